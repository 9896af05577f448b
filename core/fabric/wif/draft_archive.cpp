#include "core/fabric/wif/draft_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>

#include "core/base/error.h"
#include "core/fabric/wif/wif_sections.h"

namespace loomlight {
namespace {

constexpr const char* kDraft = "twamain.waf";

constexpr int kMostFiles =
    1000;  ///< where names are chosen so that the library is slow, it is with a hundred times as many

/// What is thrown of an archive whose bytes are damaged.
InputError damaged(const std::string& source, const std::string& how) {
  return InputError(fmt::format("{}: expected an archive of TempoWeave (.twa): {}", source, how));
}

void expectFewFiles(std::string_view bytes, const std::string& source) {
  constexpr std::string_view kListed = "PK\x01\x02";  // before each name in the list of files
  int files = 0;
  for (size_t at = bytes.find(kListed); at != bytes.npos && files <= kMostFiles; at = bytes.find(kListed, at + 1))
    ++files;
  if (files > kMostFiles) throw damaged(source, fmt::format("it has more than {} files", kMostFiles));
}

using Archive = std::unique_ptr<zip_t, decltype([](zip_t* archive) { zip_discard(archive); })>;
using Entry = std::unique_ptr<zip_file_t, decltype([](zip_file_t* entry) { zip_fclose(entry); })>;

/// `bytes` outlive it. The library keeps the error for its caller, who ends it.
Archive opened(std::string_view bytes, const std::string& source) {
  zip_error_t error;
  zip_error_init(&error);
  const std::unique_ptr<zip_error_t, decltype([](zip_error_t* of) { zip_error_fini(of); })> ended(&error);
  zip_source_t* const buffer = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (!buffer) throw damaged(source, zip_error_strerror(&error));
  Archive archive(zip_open_from_source(buffer, ZIP_RDONLY, &error));
  if (!archive) {
    zip_source_free(buffer);  // an open archive would own it
    throw damaged(source, zip_error_strerror(&error));
  }
  return archive;
}

}  // namespace

bool isDraftArchive(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04");
}

std::string draftOfArchive(std::string_view bytes, const std::string& source) {
  expectFewFiles(bytes, source);
  const Archive archive = opened(bytes, source);
  const zip_int64_t index = zip_name_locate(archive.get(), kDraft, ZIP_FL_NOCASE);
  zip_stat_t stat;
  if (index < 0 || zip_stat_index(archive.get(), static_cast<zip_uint64_t>(index), 0, &stat) != 0)
    throw InputError(fmt::format("{}: expected an archive of TempoWeave (.twa), got one without {}", source, kDraft));
  if (stat.size > kMaxWifBytes)
    throw InputError(fmt::format("{}: {}: expected at most {} bytes, got {}", source, kDraft, kMaxWifBytes, stat.size));
  if (stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
    throw damaged(source, fmt::format("{} is packed in a way that it is not in these", kDraft));
  const Entry entry(zip_fopen_index(archive.get(), static_cast<zip_uint64_t>(index), 0));
  if (!entry) throw damaged(source, zip_strerror(archive.get()));
  std::string draft(stat.size, '\0');
  const zip_int64_t length = zip_fread(entry.get(), draft.data(), draft.size());
  char beyond = 0;  // its checksum is compared when its end is read
  const zip_int64_t more = length < 0 ? 0 : zip_fread(entry.get(), &beyond, 1);
  if (length < 0 || more < 0) throw damaged(source, zip_file_strerror(entry.get()));
  if (more > 0 || length < static_cast<zip_int64_t>(draft.size()))
    throw damaged(source,
                  fmt::format("expected {} bytes of {}, got {}", draft.size(), kDraft, more > 0 ? "more" : "fewer"));
  return draft;
}

}  // namespace loomlight
