#include "app/editor/widget_dump.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/fabric/json/json_text.h"

namespace loomlight {

void WidgetDump::write(const WidgetProbe::Snapshot& snapshot) {
  if (snapshot == written_) return;
  written_ = snapshot;
  nlohmann::json widgets = nlohmann::json::object();
  for (const auto& [name, rect] : snapshot.widgets) widgets[name] = {rect.x0, rect.y0, rect.x1, rect.y1};
  const nlohmann::json all = {{"widgets", widgets}, {"facts", snapshot.facts}};
  // No flush to the disk here: it would hold up every frame, and the reader is another process on this machine.
  const std::string temporary = file_ + ".part";
  std::ofstream(temporary) << jsonText(all, 1);
  std::rename(temporary.c_str(), file_.c_str());
}

}  // namespace loomlight
