#include "app/export/sheet/pdf_profile.h"

#include <qpdf/qpdf-c.h>

#include <cassert>
#include <memory>
#include <string_view>
#include <vector>

#include "render/film/srgb_profile.h"

// How it works. cairo writes colours as numbers of an unnamed device. PDF lets the resources of a page, and of each
// form on it, say what that device is (DefaultRGB, ISO 32000-1, 8.6.5.6), so no drawing has to be written anew. Forms
// have resources of their own, in which there may be forms again.
namespace loomlight {
namespace {

struct CleanUp {
  void operator()(_qpdf_data* pdf) const { qpdf_cleanup(&pdf); }
};

/// A PDF whose objects are changed in place.
class Pdf {
 public:
  explicit Pdf(const std::string& bytes) : pdf_(qpdf_init()) {
    [[maybe_unused]] const QPDF_ERROR_CODE error =
        qpdf_read_memory(pdf(), "sheet", bytes.data(), bytes.size(), nullptr);
    assert(error == QPDF_SUCCESS);
  }

  void addProfile(const std::string& profile) {
    const qpdf_oh stream = streamOf(profile), space = qpdf_oh_new_array(pdf());
    qpdf_oh_append_item(pdf(), space, name("/ICCBased"));
    qpdf_oh_append_item(pdf(), space, stream);
    space_ = qpdf_make_indirect_object(pdf(), space);
    for (int page = 0; page < qpdf_get_num_pages(pdf()); ++page)
      addDefault(madeDictionary(qpdf_get_page_n(pdf(), static_cast<size_t>(page)), "/Resources"));
    const qpdf_oh intents = qpdf_oh_new_array(pdf());
    qpdf_oh_append_item(pdf(), intents, outputIntent(stream));
    qpdf_oh_replace_key(pdf(), qpdf_get_root(pdf()), "/OutputIntents", intents);
  }

  /// The same pages make the same file, whenever they are made.
  std::string bytes() {
    const qpdf_oh info = qpdf_oh_get_key(pdf(), qpdf_get_trailer(pdf()), "/Info");
    if (qpdf_oh_is_dictionary(pdf(), info)) qpdf_oh_remove_key(pdf(), info, "/CreationDate");
    qpdf_init_write_memory(pdf());
    qpdf_set_deterministic_ID(pdf(), QPDF_TRUE);
    qpdf_write(pdf());
    return {reinterpret_cast<const char*>(qpdf_get_buffer(pdf())), qpdf_get_buffer_length(pdf())};
  }

 private:
  qpdf_data pdf() const { return pdf_.get(); }
  qpdf_oh name(const char* text) const { return qpdf_oh_new_name(pdf(), text); }

  qpdf_oh streamOf(const std::string& profile) const {
    const qpdf_oh stream = qpdf_oh_new_stream(pdf()), none = qpdf_oh_new_null(pdf());
    qpdf_oh_replace_stream_data(pdf(), stream, reinterpret_cast<const unsigned char*>(profile.data()), profile.size(),
                                none, none);
    const qpdf_oh dictionary = qpdf_oh_get_dict(pdf(), stream);
    qpdf_oh_replace_key(pdf(), dictionary, "/N", qpdf_oh_new_integer(pdf(), 3));
    qpdf_oh_replace_key(pdf(), dictionary, "/Alternate", name("/DeviceRGB"));
    return stream;
  }

  qpdf_oh outputIntent(qpdf_oh profile) const {
    const qpdf_oh intent = qpdf_oh_new_dictionary(pdf()), called = qpdf_oh_new_string(pdf(), "sRGB IEC61966-2.1");
    qpdf_oh_replace_key(pdf(), intent, "/Type", name("/OutputIntent"));
    qpdf_oh_replace_key(pdf(), intent, "/S", name("/GTS_PDFA1"));
    qpdf_oh_replace_key(pdf(), intent, "/OutputConditionIdentifier", called);
    qpdf_oh_replace_key(pdf(), intent, "/Info", called);
    qpdf_oh_replace_key(pdf(), intent, "/RegistryName", qpdf_oh_new_string(pdf(), "http://www.color.org"));
    qpdf_oh_replace_key(pdf(), intent, "/DestOutputProfile", profile);
    return intent;
  }

  /// What is there under the key, or a new dictionary.
  qpdf_oh madeDictionary(qpdf_oh object, const char* key) const {
    if (!qpdf_oh_is_dictionary(pdf(), qpdf_oh_get_key(pdf(), object, key)))
      qpdf_oh_replace_key(pdf(), object, key, qpdf_oh_new_dictionary(pdf()));
    return qpdf_oh_get_key(pdf(), object, key);
  }

  void addDefault(qpdf_oh resources) const {
    const qpdf_oh spaces = madeDictionary(resources, "/ColorSpace");
    if (qpdf_oh_has_key(pdf(), spaces, "/DefaultRGB")) return;  // shared, or in a circle
    qpdf_oh_replace_key(pdf(), spaces, "/DefaultRGB", space_);
    const qpdf_oh drawn = madeDictionary(resources, "/XObject");
    std::vector<std::string> keys;  // at first: the list of keys is one for the whole PDF
    for (qpdf_oh_begin_dict_key_iter(pdf(), drawn); qpdf_oh_dict_more_keys(pdf());)
      keys.emplace_back(qpdf_oh_dict_next_key(pdf()));
    for (const std::string& key : keys) {
      const qpdf_oh object = qpdf_oh_get_dict(pdf(), qpdf_oh_get_key(pdf(), drawn, key.c_str()));
      if (std::string_view("/Form") == qpdf_oh_get_name(pdf(), qpdf_oh_get_key(pdf(), object, "/Subtype")))
        addDefault(madeDictionary(object, "/Resources"));
    }
  }

  std::unique_ptr<_qpdf_data, CleanUp> pdf_;
  qpdf_oh space_ = 0;
};

}  // namespace

std::string withSrgbProfile(const std::string& pdf) {
  Pdf changed(pdf);
  changed.addProfile(sRgbProfile());
  return changed.bytes();
}

}  // namespace loomlight
