#include "reference/geometry.h"

#include <embree3/rtcore.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace tsuya::reference {

struct Geometry::Data {
    Strands strands;
    Surface surface;
    std::vector<std::uint32_t> segment_point;  // first point of each segment
    std::vector<std::uint32_t> segment_strand; // of each segment
    std::vector<std::uint32_t> point_strand;   // of each point
    double widest = 0.0;                       // radius
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    ~Data()
    {
        rtcReleaseScene(scene);
        rtcReleaseDevice(device);
    }
};

namespace {

constexpr unsigned fibres_id = 0, surface_id = 1;

// Embree leaves out what it meets within two radii of a curve from a ray's origin. Rays begin this
// many of the widest radii earlier and the filter leaves out what is before their true start.
constexpr double step_back = 2.5;

// A strand has departed from a way when it has been this many radii away from it.
constexpr double departed = 3.0;

struct Query {
    RTCIntersectContext context; // first: Embree hands it to the filter
    const Geometry::Data *data;
    const Start *start;
    glm::dvec3 direction;
    float near;
};

// The stretch of a strand between two of its segments stays on the way.
bool stays(const Query &query, std::uint32_t from, std::uint32_t to)
{
    const Strands &strands = query.data->strands;
    for (std::uint32_t i = std::min(from, to) + 1; i <= std::max(from, to); i++) {
        const glm::dvec3 away = glm::dvec3(strands.points[i]) - query.start->position;
        const glm::dvec3 side = away - query.direction * glm::dot(away, query.direction);
        const double radius = std::max(strands.radius[i], strands.radius[from]);
        if (glm::dot(side, side) > departed * departed * radius * radius) {
            return false;
        }
    }
    return true;
}

void filter(const RTCFilterFunctionNArguments *args)
{
    const Query &query = *reinterpret_cast<const Query *>(args->context);
    const Geometry::Data &data = *query.data;
    const unsigned primitive = RTCHitN_primID(args->hit, args->N, 0);
    bool leave_out = !(RTCRayN_tfar(args->ray, args->N, 0) > query.near);
    if (RTCHitN_geomID(args->hit, args->N, 0) == surface_id) {
        leave_out = leave_out || query.start->triangle == primitive;
    } else if (!leave_out && query.start->point != Start::nowhere &&
               data.point_strand[query.start->point] == data.segment_strand[primitive]) {
        leave_out = stays(query, query.start->point, data.segment_point[primitive]);
    }
    if (leave_out) {
        args->valid[0] = 0;
    }
}

template <class T>
void share(RTCGeometry geometry, RTCBufferType type, unsigned slot, RTCFormat format,
           const T *values, std::size_t stride, std::size_t count)
{
    void *to = rtcSetNewGeometryBuffer(geometry, type, slot, format, stride, count);
    if (to && count > 0) {
        std::memcpy(to, values, stride * count);
    }
}

void attach(Geometry::Data &data, RTCGeometry geometry, unsigned id)
{
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(data.scene, geometry, id);
    rtcReleaseGeometry(geometry);
}

void attach_strands(Geometry::Data &data)
{
    if (data.segment_point.empty()) {
        return;
    }
    const Strands &strands = data.strands;
    std::vector<float> vertices;
    for (std::size_t i = 0; i < strands.points.size(); i++) {
        const glm::vec3 &p = strands.points[i];
        vertices.insert(vertices.end(), {p.x, p.y, p.z, strands.radius[i]});
    }
    RTCGeometry curves = rtcNewGeometry(data.device, RTC_GEOMETRY_TYPE_FLAT_LINEAR_CURVE);
    share(curves, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, vertices.data(), 4 * sizeof(float),
          strands.points.size());
    share(curves, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, data.segment_point.data(),
          sizeof(std::uint32_t), data.segment_point.size());
    attach(data, curves, fibres_id);
}

void attach_surface(Geometry::Data &data)
{
    const Surface &surface = data.surface;
    if (surface.indices.empty()) {
        return;
    }
    RTCGeometry triangles = rtcNewGeometry(data.device, RTC_GEOMETRY_TYPE_TRIANGLE);
    share(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, surface.positions.data(),
          sizeof(glm::vec3), surface.positions.size());
    share(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, surface.indices.data(),
          3 * sizeof(std::uint32_t), surface.indices.size() / 3);
    attach(data, triangles, surface_id);
}

template <class R> void aim(R &ray, const Query &query, const glm::dvec3 &direction, double back)
{
    const glm::dvec3 origin = query.start->position - back * direction;
    ray.org_x = float(origin.x);
    ray.org_y = float(origin.y);
    ray.org_z = float(origin.z);
    ray.dir_x = float(direction.x);
    ray.dir_y = float(direction.y);
    ray.dir_z = float(direction.z);
    ray.tnear = 0.0f;
    ray.tfar = std::numeric_limits<float>::infinity();
    ray.time = 0.0f;
    ray.mask = 0xffffffffu;
    ray.id = 0;
    ray.flags = 0;
}

} // namespace

Geometry::Geometry(Strands strands, Surface surface, unsigned threads)
    : data_(std::make_unique<Data>())
{
    Data &data = *data_;
    data.strands = std::move(strands);
    data.surface = std::move(surface);
    const Strands &own = data.strands;
    data.point_strand.resize(own.points.size());
    for (std::uint32_t s = 0; s + 1 < own.first.size(); s++) {
        for (std::uint32_t i = own.first[s]; i < own.first[s + 1]; i++) {
            data.point_strand[i] = s;
            data.widest = std::max(data.widest, double(own.radius[i]));
            if (i + 1 < own.first[s + 1]) {
                data.segment_point.push_back(i);
                data.segment_strand.push_back(s);
            }
        }
    }
    data.device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
    data.scene = rtcNewScene(data.device);
    rtcSetSceneFlags(data.scene, RTC_SCENE_FLAG_ROBUST);
    attach_strands(data);
    attach_surface(data);
    rtcCommitScene(data.scene);
    const RTCError error = rtcGetDeviceError(data.device);
    if (error != RTC_ERROR_NONE) {
        throw std::runtime_error(error == RTC_ERROR_OUT_OF_MEMORY
                                     ? "there is not enough memory for the groom's tree"
                                     : "Embree failed with error " + std::to_string(int(error)));
    }
}

Geometry::~Geometry() = default;

std::size_t Geometry::strands() const
{
    return data_->strands.first.empty() ? 0 : data_->strands.first.size() - 1;
}

bool Geometry::meets(const Start &start, const glm::dvec3 &direction, double near, Hit &hit) const
{
    const Data &data = *data_;
    const double back = step_back * data.widest;
    Query query;
    rtcInitIntersectContext(&query.context);
    query.data = &data;
    query.start = &start;
    query.direction = direction;
    query.near = float(back + near);
    RTCRayHit ray;
    aim(ray.ray, query, direction, back);
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(data.scene, &query.context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return false;
    }
    hit.distance = double(ray.ray.tfar) - back;
    hit.start = Start();
    const double u = double(ray.hit.u), v = double(ray.hit.v);
    if (ray.hit.geomID == fibres_id) {
        const std::uint32_t a = data.segment_point[ray.hit.primID];
        const Strands &strands = data.strands;
        hit.start.point = a;
        hit.start.position =
            (1.0 - u) * glm::dvec3(strands.points[a]) + u * glm::dvec3(strands.points[a + 1]);
        hit.tangent = glm::normalize((1.0 - u) * glm::dvec3(strands.tangent[a]) +
                                     u * glm::dvec3(strands.tangent[a + 1]));
        hit.chance = strands.chance[data.segment_strand[ray.hit.primID]];
        return true;
    }
    const std::uint32_t *corner = data.surface.indices.data() + 3 * std::size_t(ray.hit.primID);
    hit.start.triangle = ray.hit.primID;
    glm::dvec3 position(0.0), normal(0.0);
    const double share[3] = {1.0 - u - v, u, v};
    for (int k = 0; k < 3; k++) {
        position += share[k] * glm::dvec3(data.surface.positions[corner[k]]);
        normal += share[k] * glm::dvec3(data.surface.normals[corner[k]]);
    }
    hit.start.position = position;
    const glm::dvec3 facet = glm::normalize(glm::dvec3(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z));
    hit.facet = glm::dot(facet, direction) > 0.0 ? -facet : facet;
    normal = glm::normalize(normal);
    hit.normal = glm::dot(normal, hit.facet) < 0.0 ? -normal : normal;
    return true;
}

bool Geometry::blocked(const Start &start, const glm::dvec3 &direction, double far) const
{
    const Data &data = *data_;
    const double back = step_back * data.widest;
    Query query;
    rtcInitIntersectContext(&query.context);
    query.data = &data;
    query.start = &start;
    query.direction = direction;
    query.near = float(back);
    RTCRay ray;
    aim(ray, query, direction, back);
    ray.tfar = float(back + far);
    rtcOccluded1(data.scene, &query.context, &ray);
    return ray.tfar < 0.0f;
}

} // namespace tsuya::reference
