// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/read/network.hpp"

#include "geometry/error.hpp"
#include "text/words.hpp"

#include <cpl_error.h>
#include <cpl_http.h>
#include <cpl_minixml.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

#include "gdal/gdal.hpp"

namespace orograph {
namespace {

namespace fs = std::filesystem;

// Wherever they stand in a name, as in /vsizip//vsicurl/….
constexpr std::array<std::string_view, 12> kRemote{
    "/vsicurl",  "/vsis3",   "/vsigs",      "/vsiaz",     "/vsiadls", "/vsioss",
    "/vsiswift", "/vsihdfs", "/vsiwebhdfs", "<serverurl", "<gdal_w",  "<wcs_gdal"};

// Prefixes of GDAL's drivers that are clients of something.
constexpr std::array<std::string_view, 37> kClients{
    "pg:",     "postgresql:", "mysql:",    "mssql:",    "odbc:",       "oci:",
    "hana:",   "mongodbv3:",  "couchdb:",  "cloudant:", "es:",         "wms:",
    "wmts:",   "wcs:",        "wfs:",      "wfs3:",     "oapif:",      "oapif_collection:",
    "ogcapi:", "csw:",        "carto:",    "cartodb:",  "amigocloud:", "eeda:",
    "eedai:",  "plscenes:",   "plmosaic:", "ngw:",      "dods:",       "georaster:",
    "geor:",   "rasdaman:",   "daas:",     "stacit:",   "stacta:",     "gft:",
    "iip:"};

// How files begin that describe a service to one of GDAL's drivers.
constexpr std::array<std::string_view, 5> kServices{"<GDAL_WM", "<WMS_", "<WCS_GDAL",
                                                    "<OGRWFSDataSource", "<OGROAPIFDataSource"};

bool names_a_source(std::string_view element) {
  return element == "SourceFilename" || element == "SourceDataset" || element == "SrcDataSource" ||
         element == "SrcSQL";
}

bool is_vrt(std::string_view text) {
  return text.find("<VRTDataset") != text.npos || text.find("<OGRVRTDataSource") != text.npos;
}

struct FreeXml {
  void operator()(CPLXMLNode* node) const { CPLDestroyXMLNode(node); }
};

struct NamedFiles {
  std::optional<std::string> on_network; ///< the first one
  std::optional<std::string> outside;    ///< the first file that isn't below the VRT's folder
  std::size_t outside_count = 0;
};

// Walks a virtual raster or layer (VRT), and those that it names, for what GDAL would open. Other
// files name nothing.
class Walk {
public:
  explicit Walk(std::string input) : folder_(folder_of(input)) { visit(std::move(input)); }
  const NamedFiles& found() const { return found_; }

private:
  static std::string folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
  }

  void visit(std::string path) {
    constexpr std::size_t kMostFiles = 1000;
    if (path.starts_with('<')) return visit_text(path, "");
    if (visited_.size() >= kMostFiles || !visited_.insert(path).second) return;
    if (const auto text = text_of_vrt(path)) visit_text(*text, folder_of(path));
  }

  // Nothing where the file isn't one. Only virtual files are read whole.
  std::optional<std::string> text_of_vrt(const std::string& path) {
    constexpr std::size_t kHead = 4096;
    constexpr vsi_l_offset kLargest = 256 << 20;
    VSILFILE* const file = VSIFOpenL(path.c_str(), "rb");
    if (file == nullptr) return std::nullopt;
    std::string head(kHead, '\0');
    head.resize(VSIFReadL(head.data(), 1, head.size(), file));
    VSIFCloseL(file);
    if (std::ranges::any_of(kServices, [&](auto begin) { return head.find(begin) != head.npos; }))
      found_.on_network.emplace("a server");
    if (!is_vrt(head)) return std::nullopt;
    GByte* bytes = nullptr;
    vsi_l_offset size = 0;
    if (!VSIIngestFile(nullptr, path.c_str(), &bytes, &size, static_cast<GIntBig>(kLargest)))
      return std::nullopt;
    std::string text(reinterpret_cast<const char*>(bytes), size);
    VSIFree(bytes);
    return text;
  }

  void visit_text(const std::string& text, const std::string& folder) {
    const std::unique_ptr<CPLXMLNode, FreeXml> root(CPLParseXMLString(text.c_str()));
    for (const CPLXMLNode* node = root.get(); node; node = node->psNext) visit_node(*node, folder);
  }

  void visit_node(const CPLXMLNode& node, const std::string& folder) {
    if (node.eType != CXT_Element) return;
    if (names_a_source(node.pszValue)) take(node, folder);
    for (const CPLXMLNode* child = node.psChild; child; child = child->psNext)
      visit_node(*child, folder);
  }

  void take(const CPLXMLNode& node, const std::string& folder) {
    const std::string name = CPLGetXMLValue(&node, nullptr, "");
    if (is_on_network(name)) {
      if (!found_.on_network) found_.on_network = name;
      return;
    }
    if (std::string_view(node.pszValue) == "SrcSQL") return;
    const bool is_beside = CPLTestBool(CPLGetXMLValue(&node, "relativeToVRT", "0"));
    const std::string path = is_beside ? (fs::path(folder) / name).string() : name;
    VSIStatBufL stat;
    if (VSIStatExL(path.c_str(), &stat, VSI_STAT_EXISTS_FLAG) == 0 && !is_below_folder(path)) {
      if (!found_.outside) found_.outside = path;
      ++found_.outside_count;
    }
    visit(path);
  }

  // Links resolved.
  bool is_below_folder(const std::string& path) const {
    std::error_code error;
    const fs::path folder = fs::weakly_canonical(fs::absolute(folder_, error), error),
                   file = fs::weakly_canonical(fs::absolute(path, error), error);
    const fs::path way = file.lexically_relative(folder);
    return !way.empty() && *way.begin() != "..";
  }

  std::string folder_;
  std::set<std::string> visited_;
  NamedFiles found_;
};

CPLHTTPResult* refuse_request(const char*, CSLConstList, GDALProgressFunc, void*,
                              CPLHTTPFetchWriteFunc, void*, void*) {
  CPLError(CE_Failure, CPLE_AppDefined, "the file asks a server, which it mayn't");
  auto* const result = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  result->nStatus = 1;
  result->pszErrBuf = CPLStrdup("not asked");
  return result;
}

} // namespace

bool is_on_network(std::string_view name) {
  std::string text = in_lower_case(name);
  for (const std::string_view local : {"file://", "vrt://"})
    if (text.starts_with(local)) text.erase(0, local.size());
  const auto stands_in = [&](std::string_view part) { return text.find(part) != text.npos; };
  return stands_in("://") || std::ranges::any_of(kRemote, stands_in) ||
         std::ranges::any_of(kClients,
                             [&](std::string_view part) { return text.starts_with(part); });
}

// No proxy answers at port 0, so whatever GDAL asks curl for fails at once.
struct NetworkGate::Closed {
  Closed() { CPLHTTPPushFetchCallback(refuse_request, nullptr); }
  ~Closed() { CPLHTTPPopFetchCallback(); }
  Closed(const Closed&) = delete;
  Closed& operator=(const Closed&) = delete;

  static constexpr const char* kNoProxy = "http://127.0.0.1:0";
  GdalThreadOption no_file{"CPL_VSIL_CURL_ALLOWED_FILENAME", "none"},
      no_proxy{"GDAL_HTTP_PROXY", kNoProxy}, no_secure_proxy{"GDAL_HTTPS_PROXY", kNoProxy};
};

NetworkGate::NetworkGate(const std::vector<std::string>& inputs, bool is_allowed) {
  const GdalMessages unheard;
  if (!is_allowed && std::ranges::none_of(inputs, is_on_network))
    closed_ = std::make_unique<Closed>();
  for (const std::string& input : inputs) {
    if (is_on_network(input)) continue;
    const Walk walk(input);
    const NamedFiles& named = walk.found();
    if (named.on_network && closed_)
      throw Error(fmt::format("{} reads from the network ({})", input, *named.on_network),
                  "give `allow_network` if you trust it");
    if (named.outside)
      doubts_.push_back(fmt::format("{} opens {} its folder: {}", input,
                                    named.outside_count == 1
                                        ? "a file outside"
                                        : fmt::format("{} files outside", named.outside_count),
                                    *named.outside));
  }
}

NetworkGate::~NetworkGate() = default;

} // namespace orograph
