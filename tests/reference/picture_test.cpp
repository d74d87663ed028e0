// Whole pictures: the white furnace, honest errors, and sums that nothing but the seed changes.
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>

#include "reference/world.h"
#include "scene/picture.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

extern "C" {
#include <cmocka.h>
}

namespace {

using namespace tsuya;
using namespace tsuya::reference;

constexpr double pi = 3.14159265358979323846;

bool is_long()
{
    const char *text = std::getenv("TSUYA_LONG");
    return text && *text == '1';
}

unsigned cores()
{
    return std::max(1u, std::thread::hardware_concurrency());
}

struct Shot {
    World world;
    Camera camera;
    scene::Hair hair;
    scene::Material material;
    draw::Frame frame;
};

Shot shot(const std::vector<std::string> &words)
{
    const Expected<scene::Scene> scene = scene::override(scene::Scene(), words);
    if (!scene) {
        fail_msg("%s", scene.error().c_str());
    }
    Expected<scene::Hair> hair = scene::hair(*scene);
    Expected<scene::Material> material = scene::material(*scene);
    assert_true(bool(hair) && bool(material));
    Shot shot{{}, {}, *hair, *material, {}};
    shot.frame = scene::frame(*scene, shot.hair, shot.material);
    const Expected<World> world = reference::world(*scene, shot.hair, shot.material, shot.frame);
    assert_true(bool(world));
    shot.world = *world;
    shot.camera = reference::camera(shot.frame);
    return shot;
}

// Every way ends in the sky, and no fibre and no skin takes anything.
void white_furnace_by_the_sky(void **)
{
    Shot furnace = shot({"groom=wavy", "strands=6000", "width_scale=4", "sigma_a=0,0,0",
                         "light=none", "dome=1", "background=1,1,1", "size=24x24"});
    furnace.world.skin = glm::dvec3(1.0);
    const Tracer tracer(furnace.world);
    Film film(24, 24);
    assert_true(render(tracer, furnace.camera, {64, 1, cores()}, film));
    assert_true(film.summary().coverage > 0.2);
    for (int i = 0; i < 24 * 24; i++) {
        const Pixel &pixel = film.at(i % 24, i / 24);
        for (int c = 0; c < 3; c++) {
            const double off = std::abs(pixel.mean(c) - 1.0);
            assert_true(off < 1e-6 || off < 5.0 * pixel.standard_error(c));
        }
    }
    const Summary summary = film.summary();
    std::printf("furnace by the sky: %.6f\n", summary.mean);
    assert_true(std::abs(summary.mean - 1.0) < 0.005);
}

// The same by lights alone, one from a random direction for each path: now a value is in each
// path's sum, and every blocked way counts.
void white_furnace_by_lights(void **)
{
    const Shot furnace =
        shot({"groom=straight", "strands=3000", "width_scale=4", "sigma_a=0,0,0", "light=none",
              "dome=0", "head=none", "background=1,1,1", "size=16x16"});
    const int rounds = is_long() ? 16000 : 4000;
    Film film(16, 16);
    std::vector<std::thread> threads;
    for (unsigned k = 0; k < cores(); k++) {
        threads.emplace_back([&, k] {
            for (int i = int(k); i < 16 * 16; i += int(cores())) {
                for (int round = 0; round < rounds; round++) {
                    Random random(7, std::uint64_t(i), std::uint64_t(round));
                    World world = furnace.world;
                    const double y = 2.0 * random.unit() - 1.0, phi = 2.0 * pi * random.unit();
                    const double r = std::sqrt(1.0 - y * y);
                    world.lights = {
                        {{r * std::cos(phi), y, r * std::sin(phi)}, glm::dvec3(4.0 * pi)}};
                    const Path path = furnace.camera.path((i % 16 + random.unit()) / 16.0,
                                                          (i / 16 + random.unit()) / 16.0);
                    film.at(i % 16, i / 16).add(Tracer(world).sample(path, random));
                }
            }
        });
    }
    for (std::thread &thread : threads) {
        thread.join();
    }
    const Summary summary = film.summary();
    std::printf("furnace by lights: %.5f +- %.5f, coverage %.2f\n", summary.mean,
                summary.mean_error, summary.coverage);
    assert_true(summary.mean_error < 0.004);
    assert_true(std::abs(summary.mean - 1.0) < std::max(0.005, 3.0 * summary.mean_error));
    double squares = 0.0;
    int count = 0;
    for (int i = 0; i < 16 * 16; i++) {
        const Pixel &pixel = film.at(i % 16, i / 16);
        if (pixel.standard_error(3) > 0.0) {
            const double z = (pixel.mean(3) - 1.0) / pixel.standard_error(3);
            squares += z * z;
            count++;
        }
    }
    std::printf("its pixels: rms z %.2f of %d\n", std::sqrt(squares / count), count);
    assert_true(count > 50 && std::sqrt(squares / count) < 1.3);
}

const std::vector<std::string> small = {"groom=curly", "strands=3000", "width_scale=4",
                                        "color=blond", "size=12x12"};

// Spread of a pixel over seeds against the error that one seed states.
void error_is_honest(void **)
{
    const Shot scene = shot(small);
    const Tracer tracer(scene.world);
    const int seeds = is_long() ? 256 : 64;
    std::vector<Pixel> over(12 * 12);
    double stated = 0.0, spread = 0.0;
    for (int seed = 0; seed < seeds; seed++) {
        Film film(12, 12);
        render(tracer, scene.camera, {24, std::uint64_t(seed), cores()}, film);
        for (int i = 0; i < 12 * 12; i++) {
            const Pixel &pixel = film.at(i % 12, i / 12);
            stated += pixel.standard_error(1) * pixel.standard_error(1) / seeds;
            Sample mean;
            mean.radiance = glm::dvec3(pixel.mean(1));
            over[std::size_t(i)].add(mean);
        }
    }
    for (const Pixel &pixel : over) {
        spread += seeds * pixel.standard_error(1) * pixel.standard_error(1);
    }
    std::printf("spread over seeds / stated error: %.3f\n", std::sqrt(spread / stated));
    assert_true(std::abs(std::sqrt(spread / stated) - 1.0) < 0.06);
}

bool equal(const Film &a, const Film &b)
{
    const image::Image x = a.image(), y = b.image();
    return x.pixels == y.pixels;
}

void only_the_seed_changes_the_sums(void **)
{
    const Shot scene = shot(small);
    const Tracer tracer(scene.world);
    Film whole(12, 12), other(12, 12), threads(12, 12);
    assert_true(render(tracer, scene.camera, {20, 1, 1}, whole));
    assert_true(render(tracer, scene.camera, {20, 1, 5}, threads));
    assert_true(render(tracer, scene.camera, {20, 2, 1}, other));
    assert_true(equal(whole, threads));
    assert_false(equal(whole, other));
    assert_true(whole.image().names ==
                std::vector<std::string>(
                    {"R", "G", "B", "hair", "se.R", "se.G", "se.B", "se.Y"}));

    // Stopped at once, then by and by, through the file each time.
    const char *path = "picture_test.state";
    Film film(12, 12);
    int stops = 0;
    for (bool done = false; !done; stops++) {
        int left = stops;
        done = render(tracer, scene.camera, {20, 1, 2}, film, [&](double) { return left-- > 0; });
        assert_true(bool(film.write(path, 77)));
        Expected<Film> read = Film::read(path, 77, 12, 12);
        assert_true(bool(read));
        film = std::move(*read);
    }
    assert_true(stops > 1);
    assert_true(equal(whole, film));

    assert_false(bool(Film::read(path, 78, 12, 12)));
    assert_false(bool(Film::read(path, 77, 12, 13)));
    std::ofstream(path, std::ios::app) << "x";
    assert_false(bool(Film::read(path, 77, 12, 12)));
    std::ofstream(path, std::ios::trunc) << "TSUYA";
    assert_false(bool(Film::read(path, 77, 12, 12)));
    std::remove(path);
    assert_false(bool(Film::read(path, 77, 12, 12)));
}

// Same strands, widths, tapers, head and camera as the renderer: the same share of hair everywhere.
void outline_is_the_renderers(void **)
{
    constexpr int size = 96, block = 12;
    const Shot scene =
        shot({"groom=curly", "strands=3000", "width_scale=4", "turn_deg=30",
              "camera.azimuth_deg=60", "camera.elevation_deg=20", "supersample=4", "size=96x96"});
    Film film(size, size);
    assert_true(render(Tracer(scene.world), scene.camera, {64, 1, cores()}, film));
    Expected<std::unique_ptr<scene::Studio>> studio = scene::Studio::create();
    if (!studio) {
        fail_msg("%s", studio.error().c_str());
    }
    const Expected<bool> taken = (*studio)->take(scene.hair, scene.material);
    if (!taken) {
        fail_msg("%s", taken.error().c_str());
    }
    assert_true(bool((*studio)->renderer().draw(scene.frame)));
    const draw::Picture drawn = (*studio)->renderer().picture();
    double worst = 0.0, sum = 0.0;
    for (int y = 0; y < size; y += block) {
        for (int x = 0; x < size; x += block) {
            double off = 0.0;
            for (int i = 0; i < block * block; i++) {
                const int px = x + i % block, py = y + i / block;
                const Pixel &pixel = film.at(px, py);
                off += pixel.hair / double(pixel.samples) -
                       double(drawn.pixels[std::size_t(4 * (py * size + px) + 3)]);
            }
            worst = std::max(worst, std::abs(off) / (block * block));
            sum += off;
        }
    }
    std::printf("coverage: mean off by %+.4f, in a block by %.4f\n", sum / (size * size), worst);
    assert_true(film.summary().coverage > 0.2);
    assert_true(std::abs(sum) / (size * size) < 0.004);
    assert_true(worst < 0.03);
}

void other_models_are_refused(void **)
{
    const Expected<scene::Scene> scene = scene::override(scene::Scene(), {"model=kajiya_kay"});
    const Expected<scene::Material> material = scene::material(*scene);
    const Expected<FiberParams> params = fiber_params(*scene, *material);
    assert_false(bool(params));
    assert_non_null(std::strstr(params.error().c_str(), "kajiya_kay"));
}

} // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(white_furnace_by_the_sky),
        cmocka_unit_test(white_furnace_by_lights),
        cmocka_unit_test(error_is_honest),
        cmocka_unit_test(only_the_seed_changes_the_sums),
        cmocka_unit_test(outline_is_the_renderers),
        cmocka_unit_test(other_models_are_refused),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
