#include "render/scene/shell_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "render/scene/embree_device.h"

// How it works. Embree finds the triangles of the shell's boundary whose boxes a ray comes through, and asks us where
// it meets them: its own triangle test rounds otherwise on another processor (likely as it starts from the processor's
// estimate of 1 / x), so that a picture would have last bits of its own there. The first triangle that a ray enters
// through, and behind which the walk of tetrahedra agrees that there is cloth, is where it comes in. The test and the
// walk compute with different roundings, so a ray begins a little behind its origin, and one that leaves cloth that it
// never entered, having slipped between two triangles, is tried again a little aside.

namespace loomlight {
namespace {

/// How far the parameters of triangles, of a shell's planes, and of rays moved along their direction may disagree,
/// relative to the coordinates involved: faces this far behind are looked at again.
constexpr float kSlack = 1e-5f;
/// What the ray must have before it, relative likewise, to have entered at all: more than rounding, so that walking
/// makes progress, and far less than a voxel.
constexpr float kProgress = 1e-6f;
/// Rays through a vertex to the last bit slip between its triangles: the edge tests agree pairwise, but not around a
/// fan; likewise a walk may leave at a vertex where the ray just stays inside. Such rays show by leaving what they
/// never entered, and are tried again, moved aside by the progress to the four sides.
constexpr int kAttempts = 5;
/// A corner of the cloth within the slack has only few tetrahedra; no shell makes a search longer than this.
constexpr int kMaxSteps = 256;

/// The tetrahedron that holds the ray just after t, walking on from `tet`; -1 if the ray leaves the cloth before.
int tetAfter(const Shell& shell, int tet, glm::vec3 origin, glm::vec3 direction, float t) {
  for (int step = 0; step < kMaxSteps && tet >= 0; ++step) {
    int face = 0;
    if (shell.exit(tet, origin, direction, face) > t) return tet;
    tet = shell.tets()[static_cast<size_t>(tet)].neighbour[face];
  }
  return -1;
}

/// A ray as Embree carries it to the triangle test.
struct EntryContext {
  embree::QueryContext embree;  ///< first, so that Embree's pointer to it is a pointer to the whole
  glm::vec3 origin, direction;
  float tMin;
  float shift;  ///< Embree's ray starts this far behind the origin
  float progress;
  float leaves = std::numeric_limits<float>::infinity();  ///< least parameter of Embree's ray at which it goes out
};

/// Where the ray enters through a boundary face that Embree's ray meets at its parameter `tEmbree`.
ShellEntry::Hit behind(const Shell& shell, const EntryContext& context, unsigned int primitive, float tEmbree) {
  const float t = std::max(tEmbree - context.shift, context.tMin);
  const int tet = static_cast<int>(shell.boundary()[primitive].tet);
  return {t, tetAfter(shell, tet, context.origin, context.direction, t + context.progress)};
}

struct Crossing {
  float t;
  bool entering;  ///< against the face's normal, which points out of the cloth
};

/// Where a ray crosses a boundary face. Two faces with an edge in common compute the same volume for it but for the
/// sign, so that no ray slips between them.
std::optional<Crossing> cross(const Shell& shell, const Shell::BoundaryFace& face, glm::dvec3 origin,
                              glm::dvec3 direction) {
  glm::dvec3 corner[3];
  for (int i = 0; i < 3; ++i) corner[i] = glm::dvec3(shell.vertices()[face.vertex[i]]) - origin;
  double least = 0, most = 0;  // of the volumes that the direction spans with the edges
  for (int i = 0; i < 3; ++i) {
    const double volume = glm::dot(direction, glm::cross(corner[i], corner[(i + 1) % 3]));
    least = std::min(least, volume);
    most = std::max(most, volume);
  }
  const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double along = glm::dot(direction, normal);
  if ((least < 0 && most > 0) || along == 0) return std::nullopt;
  return Crossing{static_cast<float>(glm::dot(corner[0], normal) / along), along < 0};
}

/// Embree's question about a face: takes it as the nearest entry so far, unless the ray leaves through it or has no
/// cloth left behind it. Of faces at one parameter the first in order is taken, whatever order Embree asks in.
void meetFace(const RTCIntersectFunctionNArguments* arguments) {
  const auto& shell = *static_cast<const Shell*>(arguments->geometryUserPtr);
  auto& query = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  auto& context = *reinterpret_cast<EntryContext*>(arguments->context);
  RTCRay& ray = query.ray;
  const std::optional<Crossing> crossing =
      cross(shell, shell.boundary()[arguments->primID], embree::originOf(ray), embree::directionOf(ray));
  if (!crossing || crossing->t < ray.tnear || crossing->t > ray.tfar) return;
  if (!crossing->entering) {
    const bool within = crossing->t > context.tMin + 2 * context.shift;  // not merely what it has just left
    if (within) context.leaves = std::min(context.leaves, crossing->t);
    return;
  }
  if (embree::isHit(query) && crossing->t == ray.tfar && arguments->primID > query.hit.primID) return;
  if (behind(shell, context, arguments->primID, crossing->t).tet < 0) return;
  ray.tfar = crossing->t;
  query.hit.geomID = arguments->geomID;
  query.hit.primID = arguments->primID;
}

/// The box of a face, with the slack about it in which its parameter may be off (kSlack).
void boundFace(const RTCBoundsFunctionArguments* arguments) {
  const auto& shell = *static_cast<const Shell*>(arguments->geometryUserPtr);
  glm::vec3 lower(std::numeric_limits<float>::infinity()), upper(-lower);
  for (const uint32_t vertex : shell.boundary()[arguments->primID].vertex) {
    lower = glm::min(lower, shell.vertices()[vertex]);
    upper = glm::max(upper, shell.vertices()[vertex]);
  }
  *arguments->bounds_o = embree::boundsAbout(lower, upper);
}

/// Unit vectors to the four sides of a direction, by attempt 1..4; attempt 0 stays.
glm::vec3 aside(glm::vec3 direction, int attempt) {
  if (attempt == 0) return glm::vec3(0);
  const glm::vec3 axis = std::abs(direction.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(direction, axis));
  const glm::vec3 side = attempt <= 2 ? right : glm::cross(direction, right);
  return attempt % 2 == 1 ? side : -side;
}

}  // namespace

void ShellEntry::ReleaseScene::operator()(RTCSceneTy* scene) const {
  rtcReleaseScene(scene);
}

ShellEntry::ShellEntry(std::shared_ptr<const Shell> shell) : shell_(std::move(shell)) {
  const glm::vec3 extent = glm::max(glm::abs(shell_->lower_mm()), glm::abs(shell_->upper_mm()));
  reach_ = std::max({extent.x, extent.y, extent.z});
  if (shell_->isFlat()) return;

  device_ = std::make_unique<const EmbreeDevice>();
  scene_.reset(rtcNewScene(*device_));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(*device_, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned int>(shell_->boundary().size()));
  rtcSetGeometryUserData(geometry, const_cast<Shell*>(shell_.get()));
  rtcSetGeometryBoundsFunction(geometry, boundFace, nullptr);
  rtcSetGeometryIntersectFunction(geometry, meetFace);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_.get(), geometry);
  rtcReleaseGeometry(geometry);
  device_->commit(scene_.get(), 1);  // it takes milliseconds
  if (rtcGetDeviceError(*device_) != RTC_ERROR_NONE) throw std::bad_alloc();
}

ShellEntry::~ShellEntry() = default;

std::optional<ShellEntry::Hit> ShellEntry::enter(glm::vec3 origin, glm::vec3 direction, float tMin, float tMax) const {
  if (shell_->isFlat()) return enterBox(origin, direction, tMin, tMax);
  const float far = std::max({reach_, std::abs(origin.x), std::abs(origin.y), std::abs(origin.z), tMin});
  const float shift = kSlack * far;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    EntryContext context{{}, origin, direction, tMin, shift, kProgress * far};
    embree::initialise(context.embree);
    const glm::vec3 start = origin - shift * direction + context.progress * aside(direction, attempt);
    // It begins as far behind the true tMin as the origin was moved.
    const RTCRay ray = embree::rayOf(start, direction, tMin, tMax + shift);
    const RTCRayHit met = embree::nearestHit(scene_.get(), context.embree, ray);
    const bool entered = embree::isHit(met);
    const bool slipped = context.leaves < (entered ? met.ray.tfar : std::numeric_limits<float>::infinity());
    if (entered && (!slipped || attempt + 1 == kAttempts))
      return behind(*shell_, context, met.hit.primID, met.ray.tfar);
    if (!slipped) break;
  }
  return std::nullopt;
}

std::optional<ShellEntry::Hit> ShellEntry::enterBox(glm::vec3 origin, glm::vec3 direction, float tMin,
                                                    float tMax) const {
  float enter = -std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const float lower = shell_->lower_mm()[axis], upper = shell_->upper_mm()[axis];
    if (direction[axis] == 0) {
      if (origin[axis] < lower || origin[axis] > upper) return std::nullopt;
      continue;
    }
    const float wall = direction[axis] > 0 ? lower : upper;
    enter = std::max(enter, (wall - origin[axis]) / direction[axis]);
  }
  int face = 0;
  const float leave = shell_->exit(0, origin, direction, face);
  if (enter < tMin || enter > tMax || enter >= leave) return std::nullopt;
  return Hit{enter, 0};
}

}  // namespace loomlight
