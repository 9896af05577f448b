#include "app/export/handover/restricted_zip.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "core/base/error.h"
#include "core/base/little_endian.h"

namespace loomlight {
namespace {

constexpr uint16_t kMadeBy = 0x003F, kNeeded = 0x14, kUtf8Names = 1 << 11, kStored = 0;

/// As MS-DOS has them: two seconds a step, from 1980 on.
struct DosTime {
  uint16_t time, date;

  explicit DosTime(std::chrono::sys_seconds when) {
    const auto day = std::chrono::floor<std::chrono::days>(when);
    const std::chrono::year_month_day calendar(day);
    const std::chrono::hh_mm_ss clock(when - day);
    time =
        static_cast<uint16_t>(clock.hours().count() << 11 | clock.minutes().count() << 5 | clock.seconds().count() / 2);
    const int year = std::clamp(static_cast<int>(calendar.year()) - 1980, 0, 127);
    date = static_cast<uint16_t>(year << 9 | static_cast<unsigned>(calendar.month()) << 5 |
                                 static_cast<unsigned>(calendar.day()));
  }
};

/// What stands of a file both before its content and in the directory.
void putCommon(LittleEndian& to, const ArchivedFile& file, uint32_t crc, const DosTime& time) {
  const auto size = static_cast<uint32_t>(file.content.size());
  to.u16(kNeeded).u16(kUtf8Names).u16(kStored).u16(time.time).u16(time.date).u32(crc).u32(size).u32(size);
  to.u16(static_cast<uint16_t>(file.path.size())).u16(0);
}

}  // namespace

std::string restrictedZip(std::span<const ArchivedFile> files, std::chrono::sys_seconds when, const std::string& name) {
  const DosTime time(when);
  size_t total = 0;
  for (const ArchivedFile& file : files) total += file.content.size() + 2 * file.path.size() + 128;
  if (total > std::numeric_limits<uint32_t>::max() || files.size() > std::numeric_limits<uint16_t>::max())
    throw InputError(fmt::format("{}: expected at most 4 GB and 65535 files, got {} files with {} bytes", name,
                                 files.size(), total));
  LittleEndian archive, directory;
  for (const ArchivedFile& file : files) {
    const auto offset = static_cast<uint32_t>(archive.size());
    const auto crc =
        static_cast<uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(file.content.data()), file.content.size()));
    archive.u32(0x04034b50);
    putCommon(archive, file, crc, time);
    archive.text(file.path).text(file.content);
    directory.u32(0x02014b50).u16(kMadeBy);
    putCommon(directory, file, crc, time);
    directory.u16(0).u16(0).u16(0).u32(0).u32(offset).text(file.path);  // no comment, first disk, no attributes
  }
  const auto begin = static_cast<uint32_t>(archive.size());
  const auto count = static_cast<uint16_t>(files.size());
  archive.text(directory.bytes());
  archive.u32(0x06054b50).u16(0).u16(0).u16(count).u16(count).u32(static_cast<uint32_t>(directory.size()));
  archive.u32(begin).u16(0);
  return archive.bytes();
}

}  // namespace loomlight
