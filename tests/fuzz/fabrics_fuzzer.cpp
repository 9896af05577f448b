#include "core/fabric/json/fabric_json.h"
#include "tests/fuzz/finding.h"
#include "tests/fuzz/fuzzers.h"

namespace loomlight::fuzz {

void fuzzFabrics(std::string_view bytes) {
  Fabric fabric;
  if (!isRead("a.json", [&] { fabric = fabricFromJson(bytes, "a.json"); })) return;
  const std::string text = fabricToJson(fabric);
  const Fabric again = fabricFromJson(text, "again.json");
  expect(again == fabric, "the fabric is written as another");
  expect(fabricToJson(again) == text, "the same fabric is written otherwise");
}

}  // namespace loomlight::fuzz
