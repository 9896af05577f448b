#include "app/editor/gl/system_profile.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <memory>

namespace loomlight {
namespace {

struct CloseDisplay {
  void operator()(Display* display) const { XCloseDisplay(display); }
};
struct FreeProperty {
  void operator()(unsigned char* data) const { XFree(data); }
};

}  // namespace

std::string systemDisplayProfile() {
  // A connection of its own, whichever window system the window has.
  const std::unique_ptr<Display, CloseDisplay> display(XOpenDisplay(nullptr));
  if (!display) return {};
  const Atom name = XInternAtom(display.get(), "_ICC_PROFILE", True);
  if (name == None) return {};
  constexpr long kMostBytes = 64'000'000;
  Atom type = None;
  int bitsPerItem = 0;
  unsigned long items = 0, left = 0;
  unsigned char* data = nullptr;
  const int status = XGetWindowProperty(display.get(), DefaultRootWindow(display.get()), name, 0, kMostBytes / 4, False,
                                        AnyPropertyType, &type, &bitsPerItem, &items, &left, &data);
  const std::unique_ptr<unsigned char, FreeProperty> kept(data);
  if (status != Success || bitsPerItem != 8 || left > 0 || !data) return {};
  return {reinterpret_cast<const char*>(data), items};
}

}  // namespace loomlight
