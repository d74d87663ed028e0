#include "reference/tracer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace tsuya::reference {

namespace {

constexpr double pi = 3.14159265358979323846;

// Paths that carry less than this in their strongest channel are given up by chance.
constexpr double faint = 0.2;
// Without absorption only geometry ends a path. Past this many meetings one in fifty ends, so that
// a path caught between surfaces does too.
constexpr int patience = 1000;

// A direction with density cos/pi around n.
glm::dvec3 cosine(const glm::dvec3 &n, Random &random)
{
    const double r = std::sqrt(random.unit()), phi = 2.0 * pi * random.unit();
    const glm::dvec3 other =
        std::abs(n.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(n, other)), w = glm::cross(n, u);
    return glm::normalize(r * (u * std::cos(phi) + w * std::sin(phi)) +
                          n * std::sqrt(std::max(0.0, 1.0 - r * r)));
}

} // namespace

template <class Take> void Tracer::light(const Start &start, Random &random, Take take) const
{
    const auto follow = [&](const Way &way) {
        if (way.irradiance != glm::dvec3(0.0) &&
            !world_.geometry->blocked(start, way.direction, way.length)) {
            take(way);
        }
    };
    for (const Light &light : world_.lights) {
        follow(light.way(start.position, random));
    }
    if (world_.around) {
        follow(world_.around->way(random));
    }
}

void Tracer::scatter(const Hit &hit, Path &path, Random &random, glm::dvec3 *direct) const
{
    const glm::dvec3 v = -path.direction;
    if (direct) {
        light(hit.start, random, [&](const Way &way) {
            *direct += path.throughput * way.irradiance *
                       world_.fiber->value(hit.tangent, way.direction, v, hit.chance);
        });
    }
    path.direction = world_.fiber->sample(hit.tangent, v, hit.chance, path.throughput, random);
}

void Tracer::reflect(const Hit &hit, Path &path, Random &random, glm::dvec3 *direct) const
{
    path.throughput *= world_.skin;
    if (direct) {
        light(hit.start, random, [&](const Way &way) {
            *direct += path.throughput * way.irradiance *
                       (std::max(glm::dot(hit.normal, way.direction), 0.0) / pi);
        });
    }
    // The interpolated normal may send light under the facet; turned up, none is lost.
    const glm::dvec3 l = cosine(hit.normal, random);
    const double up = glm::dot(l, hit.facet);
    path.direction = up < 0.0 ? glm::normalize(l - 2.0 * up * hit.facet) : l;
}

Fate Tracer::advance(Path &path, Random &random, glm::dvec3 *direct, Hit *met) const
{
    Hit hit;
    if (!world_.geometry->meets(path.start, path.direction, path.near, hit)) {
        return Fate::escaped;
    }
    if (hit.fibre()) {
        scatter(hit, path, random, direct);
    } else {
        reflect(hit, path, random, direct);
    }
    path.start = hit.start;
    path.near = 0.0;
    path.meetings++;
    if (met) {
        *met = hit;
    }
    const glm::dvec3 &t = path.throughput;
    double go_on = std::min(std::max(t.x, std::max(t.y, t.z)) / faint, 1.0);
    go_on *= path.meetings > patience ? 0.98 : 1.0;
    if (go_on < 1.0) {
        if (random.unit() >= go_on) {
            return Fate::ended;
        }
        path.throughput /= go_on;
    }
    return Fate::scattered;
}

Sample Tracer::sample(const Path &start, Random &random) const
{
    Sample sample;
    Path path = start;
    Hit hit;
    Fate fate = advance(path, random, &sample.radiance, &hit);
    if (fate == Fate::escaped) {
        sample.radiance = world_.background;
        return sample;
    }
    sample.hair = hit.fibre() ? 1.0 : 0.0;
    while (fate == Fate::scattered) {
        fate = advance(path, random, &sample.radiance, nullptr);
    }
    if (fate == Fate::escaped) {
        sample.radiance += path.throughput * world_.sky;
        if (world_.around) {
            sample.radiance += path.throughput * world_.around->radiance(path.direction);
        }
    }
    return sample;
}

} // namespace tsuya::reference
