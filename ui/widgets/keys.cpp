#include "ui/widgets/keys.h"

#include <imgui_internal.h>

namespace loomlight {

void focusNextItem() {
  ImGui::SetKeyboardFocusHere();
#if IMGUI_VERSION_NUM == 19010
  // Dear ImGui 1.90.1 (Debian 13) looks for it only in the scope that had the keyboard before (its issue 7226).
  ImGuiContext& context = *ImGui::GetCurrentContext();
  context.NavFocusScopeId = context.CurrentFocusScopeId;
#endif
}

}  // namespace loomlight
