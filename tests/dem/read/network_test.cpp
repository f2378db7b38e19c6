// SPDX-License-Identifier: GPL-3.0-or-later
// Files don't lead GDAL to the network, nor unheard to other folders.
#include "dem/read/network.hpp"
#include "dem/read/raster_bands.hpp"
#include "dem/read/read_line.hpp"
#include "dem/read/read_terrain.hpp"
#include "geometry/error.hpp"
#include "tests/catch.hpp"
#include "tests/dem/temp_folder.hpp"

#include <arpa/inet.h>
#include <cpl_conv.h>
#include <cpl_http.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "gdal/gdal.hpp"

namespace orograph::network_test {
namespace {

// Counts who calls, and hangs up.
class Server {
public:
  Server() : socket_(socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    REQUIRE(bind(socket_, any, size) == 0);
    REQUIRE(listen(socket_, 16) == 0);
    REQUIRE(getsockname(socket_, any, &size) == 0);
    url_ = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/heights.tif";
    thread_ = std::thread([this] {
      for (int caller; (caller = accept(socket_, nullptr, nullptr)) >= 0; ::close(caller)) ++calls_;
    });
  }
  ~Server() {
    shutdown(socket_, SHUT_RDWR);
    thread_.join();
    ::close(socket_);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  const std::string& url() const { return url_; }
  int calls() const { return calls_; }

private:
  int socket_;
  std::atomic<int> calls_ = 0;
  std::string url_;
  std::thread thread_;
};

std::string vrt_of(const std::string& source, bool beside = false) {
  return "<VRTDataset rasterXSize='4' rasterYSize='4'><VRTRasterBand dataType='Float32' band='1'>"
         "<SimpleSource><SourceFilename relativeToVRT='" +
         std::string(beside ? "1" : "0") + "'>" + source +
         "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
}

std::string layers_of(const std::string& source) {
  return "<OGRVRTDataSource><OGRVRTLayer name='a'><SrcDataSource>" + source +
         "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>";
}

constexpr auto kGrid = "ncols 4\nnrows 4\ncellsize 1\nxllcorner 0\nyllcorner 0\n"
                       "1 2 3 4\n2 3 4 5\n3 4 5 6\n4 5 6 7\n";

std::string write(const TempFolder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder.file(name)) << text;
  return folder.file(name);
}

template <class Read>
std::string error_of(const Read& read) {
  try {
    read();
  } catch (const Error& error) {
    return error.what();
  }
  return "none";
}

void ask(const std::string& url) {
  const GdalMessages unheard;
  CPLHTTPDestroyResult(CPLHTTPFetch(url.c_str(), nullptr));
  for (const char* way : {"/vsicurl/", "/vsicurl_streaming/"}) {
    VSIStatBufL stat;
    CHECK(VSIStatL((way + url).c_str(), &stat) != 0);
  }
}

} // namespace

TEST_CASE("names on the network are known") {
  for (const char* name :
       {"http://a.org/x.tif", "/vsicurl/http://a.org/x.tif", "/vsizip//vsis3/bucket/x.zip/x.tif",
        "PG:host=a", "pg:dbname=b", "WMS:http://a.org", "NETCDF:\"https://a.org/x.nc\":z",
        "<GDAL_WMS><Service/></GDAL_WMS>", "ftp://a.org/x", "/vsigs_streaming/x"})
    CHECK(is_on_network(name));
  for (const char* name : {"x.tif", "/vsizip/x.zip/x.tif", "file:///x.tif", "vrt://x.tif?bands=1",
                           "NETCDF:x.nc:z", "png:x", "/vsimem/x.tif", "", "GTIFF_DIR:1:x.tif"})
    CHECK_FALSE(is_on_network(name));
}

TEST_CASE("behind a closed gate GDAL calls nobody, and behind an open one it does") {
  GDALAllRegister();
  const Server server;
  {
    const NetworkGate gate({"x.tif"}, false);
    ask(server.url());
    CHECK(server.calls() == 0);
    const NetworkGate open({"x.tif", server.url()}, false); // within, as its own input says
    CHECK(server.calls() == 0);
  }
  CHECK(CPLGetThreadLocalConfigOption("GDAL_HTTP_PROXY", nullptr) == nullptr);
  VSICurlClearCache();
  {
    const NetworkGate gate({server.url()}, false);
    ask(server.url());
    CHECK(server.calls() >= 3);
  }
  const int before = server.calls();
  VSICurlClearCache();
  {
    const NetworkGate gate({"x.tif"}, true);
    ask(server.url());
    CHECK(server.calls() >= before + 3);
  }
}

TEST_CASE("a file that reads from the network is refused before anyone is called") {
  const Server server;
  const TempFolder folder;
  const std::string remote = write(folder, "remote.vrt", vrt_of("/vsicurl/" + server.url()));
  for (const std::string& path :
       {remote, write(folder, "behind.vrt", vrt_of("remote.vrt", true)),
        write(folder, "inline.vrt",
              vrt_of("&lt;VRTDataset&gt;" + std::string("&lt;SourceFilename&gt;") + server.url() +
                     "&lt;/SourceFilename&gt;&lt;/VRTDataset&gt;")),
        write(folder, "layers.vrt", layers_of("PG:host=127.0.0.1")),
        write(folder, "service.xml",
              "<GDAL_WMS><Service name='TMS'><ServerUrl>" + server.url() +
                  "</ServerUrl></Service></GDAL_WMS>")}) {
    INFO(path);
    CHECK(error_of([&] { read_terrain(path); }).starts_with(path + " reads from the network ("));
    CHECK(error_of([&] { read_line(path); }).starts_with(path + " reads from the network ("));
    CHECK(error_of([&] { index_of({path}, {}); }).starts_with(path + " reads from the network ("));
    CHECK(server.calls() == 0);
  }
  // That is all that stands between them and the server.
  ReadOptions options;
  options.allow_network = true;
  CHECK_THROWS_AS(read_terrain(remote, options), Error);
  CHECK(server.calls() > 0);
}

TEST_CASE("files outside a virtual raster's folder are told of") {
  const TempFolder folder;
  std::filesystem::create_directory(folder.file("below"));
  std::filesystem::create_directory(folder.file("other"));
  const std::string grid = write(folder, "below/grid.asc", kGrid);
  std::filesystem::create_symlink(grid, folder.file("other/link.asc"));
  const auto doubts_of = [&](const std::string& path) {
    return NetworkGate({path}, false).doubts();
  };
  CHECK(doubts_of(grid).empty());
  CHECK(doubts_of(write(folder, "all.vrt", vrt_of("below/grid.asc", true))).empty());
  CHECK(doubts_of(write(folder, "absolute.vrt", vrt_of(grid))).empty());
  CHECK(doubts_of(write(folder, "none.vrt", vrt_of("/no/such/file"))).empty());
  const std::string outside = write(folder, "other/out.vrt", vrt_of("../below/grid.asc", true));
  REQUIRE(doubts_of(outside).size() == 1);
  CHECK(doubts_of(outside).front().starts_with(outside + " opens a file outside its folder: "));
  CHECK(doubts_of(write(folder, "other/link.vrt", vrt_of("link.asc", true))).size() == 1);
  CHECK(doubts_of(write(folder, "nested.vrt", vrt_of("other/out.vrt", true))).empty());
  const TerrainData terrain = read_terrain(outside);
  CHECK(std::ranges::count(terrain.doubts, doubts_of(outside).front()) == 1);
  CHECK(std::ranges::count(terrain.notes, doubts_of(outside).front()) == 1);
  // One that names itself ends, too.
  CHECK(doubts_of(write(folder, "self.vrt", vrt_of("self.vrt", true))).empty());
}

} // namespace orograph::network_test
