#include "core/fabric/wif/draft_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "core/base/error.h"
#include "core/fabric/wif/wif_sections.h"

namespace loomlight {
namespace {

constexpr const char* kDraft = "twamain.waf";

/// What is thrown of an archive whose bytes are damaged.
InputError damaged(const std::string& source, zip_error_t* error) {
  return InputError(fmt::format("{}: expected an archive of TempoWeave (.twa): {}", source, zip_error_strerror(error)));
}

using Archive = std::unique_ptr<zip_t, decltype([](zip_t* archive) { zip_discard(archive); })>;
using Entry = std::unique_ptr<zip_file_t, decltype([](zip_file_t* entry) { zip_fclose(entry); })>;

/// `bytes` outlive it. The library keeps the error for its caller, who ends it.
Archive opened(std::string_view bytes, const std::string& source) {
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_error_t, decltype([](zip_error_t* of) { zip_error_fini(of); })> ended(&error);
  zip_source_t* const buffer = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (!buffer) throw damaged(source, &error);
  Archive archive(zip_open_from_source(buffer, ZIP_RDONLY, &error));
  if (!archive) {
    zip_source_free(buffer);  // an open archive would own it
    throw damaged(source, &error);
  }
  return archive;
}

}  // namespace

bool isDraftArchive(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::string draftOfArchive(std::string_view bytes, const std::string& source) {
  const Archive archive = opened(bytes, source);
  const zip_int64_t index = zip_name_locate(archive.get(), kDraft, ZIP_FL_NOCASE);
  zip_stat_t stat;
  if (index < 0 || zip_stat_index(archive.get(), static_cast<zip_uint64_t>(index), 0, &stat) != 0)
    throw InputError(fmt::format("{}: expected an archive of TempoWeave (.twa), got one without {}", source, kDraft));
  if (stat.size > kMaxWifBytes)
    throw InputError(fmt::format("{}: {}: expected at most {} bytes, got {}", source, kDraft, kMaxWifBytes, stat.size));
  const Entry entry(zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(index), 0));
  if (!entry) throw damaged(source, zip_get_error(archive.get()));
  std::string draft(stat.size, '\0');
  // Where the entry has more than it says, or its checksum is another, the read beyond its end is refused.
  const bool isRead = zip_fread(entry.get(), draft.data(), draft.size()) == static_cast<zip_int64_t>(draft.size());
  char beyond;
  if (!isRead || zip_fread(entry.get(), &beyond, 1) != 0) throw damaged(source, zip_file_get_error(entry.get()));
  return draft;
}

}  // namespace loomlight
