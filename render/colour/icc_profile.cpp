#include "render/colour/icc_profile.h"

#include <fmt/format.h>
#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/file.h"
#include "render/colour/colour_space.h"

// How it works. Little CMS reads profiles and carries colours from one device to another; here it is asked at the
// corners of a cube only, once for a profile, and the picture is looked up between them. The way to a printer goes in
// two steps, sRGB to inks and inks to what is seen of them, as between the two the amounts of ink must be cut off at
// what can be printed: profiles that are formulas, not tables, would go beyond.
namespace loomlight {
namespace {

constexpr size_t kMostProfileBytes = 64'000'000;  // tables of many inks take a few million

/// A context of Little CMS that keeps its last complaint, in place of one for the whole process.
class Context {
 public:
  Context() : context_(cmsCreateContext(nullptr, this)) {
    cmsSetLogErrorHandlerTHR(context_, [](cmsContext context, cmsUInt32Number, const char* text) {
      static_cast<Context*>(cmsGetContextUserData(context))->complaint_ = text;
    });
  }
  ~Context() { cmsDeleteContext(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  cmsContext get() const { return context_; }
  std::string complaint() const { return complaint_.empty() ? "no reason was given" : complaint_; }

 private:
  std::string complaint_;
  cmsContext context_;
};

struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
using Profile = std::unique_ptr<void, CloseProfile>;

struct DeleteTransform {
  void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using Transform = std::unique_ptr<void, DeleteTransform>;

Profile opened(const Context& context, const std::string& bytes) {
  return Profile(cmsOpenProfileFromMemTHR(context.get(), bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
}

/// What a profile is of, where it is of no display and no printer.
std::string otherKind(cmsProfileClassSignature kind) {
  switch (kind) {
    case cmsSigInputClass:
      return "of a camera or scanner";
    case cmsSigLinkClass:
      return "a link from one device to another";
    case cmsSigAbstractClass:
      return "an effect upon colours";
    case cmsSigColorSpaceClass:
      return "a space of colours without a device";
    case cmsSigNamedColorClass:
      return "a list of named colours";
    default:
      return "of an unknown kind";
  }
}

std::optional<IccProfile::Device> deviceOf(cmsHPROFILE profile) {
  switch (cmsGetDeviceClass(profile)) {
    case cmsSigDisplayClass:
      return IccProfile::Device::display;
    case cmsSigOutputClass:
      return IccProfile::Device::printer;
    default:
      return std::nullopt;
  }
}

std::string describedAs(cmsHPROFILE profile) {
  std::array<char, 256> text{};
  const auto room = static_cast<cmsUInt32Number>(text.size());
  cmsGetProfileInfoASCII(profile, cmsInfoDescription, cmsNoLanguage, cmsNoCountry, text.data(), room);
  return text.data();
}

constexpr cmsUInt32Number kRgb = TYPE_RGB_FLT, kLab = TYPE_Lab_FLT;

/// Of a device's own numbers, as floats: 0 to 1, inks 0 to 100.
cmsUInt32Number formatOf(cmsHPROFILE profile) {
  return cmsFormatterForColorspaceOfProfile(profile, sizeof(float), true);
}

Transform between(const Context& context, const std::string& what, const Profile& from, cmsUInt32Number fromFormat,
                  const Profile& to, cmsUInt32Number toFormat, bool blackPoint) {
  const cmsUInt32Number flags = cmsFLAGS_NOOPTIMIZE | cmsFLAGS_NOCACHE |
                                (blackPoint ? static_cast<cmsUInt32Number>(cmsFLAGS_BLACKPOINTCOMPENSATION) : 0);
  Transform made(cmsCreateTransformTHR(context.get(), from.get(), fromFormat, to.get(), toFormat,
                                       INTENT_RELATIVE_COLORIMETRIC, flags));
  if (!made) throw InputError(fmt::format("{}: this profile cannot be used: {}", what, context.complaint()));
  return made;
}

/// The colours of a cube's corners, sRGB-encoded.
std::vector<glm::vec3> cornerColours() {
  std::vector<glm::vec3> colours;
  constexpr int n = ColourCube::kSide;
  colours.reserve(size_t{n} * n * n);
  for (int b = 0; b < n; ++b)
    for (int g = 0; g < n; ++g)
      for (int r = 0; r < n; ++r)
        colours.emplace_back(ColourCube::cornerAt(r), ColourCube::cornerAt(g), ColourCube::cornerAt(b));
  return colours;
}

std::vector<glm::vec3> transformed(const Transform& transform, const void* colours, size_t count) {
  std::vector<glm::vec3> result(count);
  cmsDoTransform(transform.get(), colours, result.data(), static_cast<cmsUInt32Number>(count));
  return result;
}

/// Not a number, as a broken table may give, is black.
glm::vec3 shown(const glm::vec3& encoded) {
  glm::vec3 c(0.0f);
  for (int i = 0; i < 3; ++i)
    if (encoded[i] > 0) c[i] = std::min(encoded[i], 1.0f);
  return c;
}

Lab labOf(const glm::vec3& lab) {
  return {lab.x, lab.y, lab.z};
}

/// To what a display must be sent. `what` stands for the profile in messages.
class DisplayWay {
 public:
  DisplayWay(const IccProfile& display, const std::string& what)
      : toDevice_(between(context_, what, Profile(cmsCreate_sRGBProfileTHR(context_.get())), kRgb,
                          opened(context_, display.bytes), kRgb, true)) {}

  std::vector<glm::vec3> sent(const std::vector<glm::vec3>& colours) const {
    return transformed(toDevice_, colours.data(), colours.size());
  }

 private:
  Context context_;
  Transform toDevice_;
};

/// To a printer's inks, and from them to what is seen. `what` stands for the profile in messages.
class PrintWay {
 public:
  PrintWay(const IccProfile& printer, const std::string& what) {
    const Profile standard(cmsCreate_sRGBProfileTHR(context_.get()));
    const Profile lab(cmsCreateLab4ProfileTHR(context_.get(), nullptr));
    const Profile device = opened(context_, printer.bytes);
    const cmsColorSpaceSignature space = cmsGetColorSpace(device.get());
    const cmsUInt32Number inks = formatOf(device.get());
    inkCount_ = cmsChannelsOf(space);
    fullInk_ = space == cmsSigRgbData || space == cmsSigGrayData ? 1.0f : 100.0f;
    toInks_ = between(context_, what, standard, kRgb, device, inks, true);
    toNearestInks_ = between(context_, what, standard, kRgb, device, inks, false);
    toScreen_ = between(context_, what, device, inks, standard, kRgb, false);
    inksToLab_ = between(context_, what, device, inks, lab, kLab, false);
    toLab_ = between(context_, what, standard, kRgb, lab, kLab, false);
  }

  std::vector<glm::vec3> prints(const std::vector<glm::vec3>& colours) const {
    return transformed(toScreen_, amounts(toInks_, colours).data(), colours.size());
  }
  std::vector<float> outOfGamut_deltaE(const std::vector<glm::vec3>& colours) const {
    const std::vector<glm::vec3> wanted = transformed(toLab_, colours.data(), colours.size()),
                                 had = transformed(inksToLab_, amounts(toNearestInks_, colours).data(), colours.size());
    std::vector<float> differences;
    differences.reserve(colours.size());
    for (size_t i = 0; i < colours.size(); ++i) {
      const auto difference = static_cast<float>(ciede2000(labOf(wanted[i]), labOf(had[i])));
      differences.push_back(difference >= 0 ? difference : 0.0f);  // not a number: a broken table
    }
    return differences;
  }

 private:
  std::vector<float> amounts(const Transform& transform, const std::vector<glm::vec3>& colours) const {
    std::vector<float> inks(colours.size() * inkCount_);
    cmsDoTransform(transform.get(), colours.data(), inks.data(), static_cast<cmsUInt32Number>(colours.size()));
    for (float& ink : inks) ink = ink > 0 ? std::min(ink, fullInk_) : 0.0f;
    return inks;
  }

  Context context_;
  size_t inkCount_ = 0;
  float fullInk_ = 1;
  Transform toInks_, toNearestInks_, toScreen_, inksToLab_, toLab_;
};

}  // namespace

IccProfile iccProfile(std::string bytes, const std::string& from) {
  const Context context;
  const Profile profile = opened(context, bytes);
  if (!profile) throw InputError(fmt::format("{}: expected a colour profile (ICC): {}", from, context.complaint()));
  const std::optional<IccProfile::Device> device = deviceOf(profile.get());
  if (!device)
    throw InputError(fmt::format("{}: expected the profile of a display or a printer; this one is {}", from,
                                 otherKind(cmsGetDeviceClass(profile.get()))));
  const cmsColorSpaceSignature space = cmsGetColorSpace(profile.get());
  if (*device == IccProfile::Device::display && space != cmsSigRgbData)
    throw InputError(fmt::format("{}: expected the profile of a display of red, green and blue", from));
  if (cmsChannelsOf(space) > cmsMAXCHANNELS || formatOf(profile.get()) == 0)
    throw InputError(fmt::format("{}: inks that this program does not know", from));
  IccProfile made{*device, describedAs(profile.get()), std::move(bytes)};
  if (made.description.empty()) made.description = std::filesystem::path(from).filename().string();
  // What lacks the tables that are needed is found out here, where it can be said, and not when it is used.
  if (made.device == IccProfile::Device::display) {
    DisplayWay(made, from);
  } else {
    PrintWay(made, from);
  }
  return made;
}

IccProfile readIccProfile(const std::string& file) {
  return iccProfile(readFile(file, kMostProfileBytes), file);
}

ColourCube displayCube(const IccProfile& display) {
  std::vector<glm::vec4> corners;
  for (const glm::vec3& sent : DisplayWay(display, display.description).sent(cornerColours()))
    corners.emplace_back(shown(sent), 1.0f);
  return ColourCube(std::move(corners));
}

ColourCube proofCube(const IccProfile& printer) {
  const PrintWay way(printer, printer.description);
  const std::vector<glm::vec3> colours = cornerColours(), prints = way.prints(colours);
  const std::vector<float> differences = way.outOfGamut_deltaE(colours);
  std::vector<glm::vec4> corners;
  corners.reserve(colours.size());
  for (size_t i = 0; i < colours.size(); ++i) corners.emplace_back(shown(prints[i]), differences[i]);
  return ColourCube(std::move(corners));
}

}  // namespace loomlight
