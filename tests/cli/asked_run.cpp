// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/cli/asked_run.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>

namespace orograph {
namespace {

constexpr std::size_t kLongest = 200000;
using Descriptors = std::array<int, 2>;

/// A message of this text, with room for two descriptors beside it.
struct Message {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(Descriptors))> beside{};
  iovec text{};
  msghdr header{};
  Message(char* begin, std::size_t size) : text{begin, size} {
    header.msg_iov = &text;
    header.msg_iovlen = 1;
    header.msg_control = beside.data();
    header.msg_controllen = beside.size();
  }
};

} // namespace

bool take_on(const RunConditions& conditions, int out, int err) {
  if (!conditions.folder.empty() && ::chdir(conditions.folder.c_str()) != 0) return false;
  if (!conditions.out_path.empty()) out = ::open(conditions.out_path.c_str(), O_WRONLY);
  if (::dup2(out, STDOUT_FILENO) < 0 || ::dup2(err, STDERR_FILENO) < 0) return false;
  if (!conditions.largest_file_bytes) return true;
  const rlimit limit{*conditions.largest_file_bytes, *conditions.largest_file_bytes};
  return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

bool ask_for_run(int socket, const AskedRun& run) {
  // One after the other, each ended by a NUL, which no argument holds.
  std::string text;
  const auto add = [&](const std::string& part) { (text += part) += '\0'; };
  add(run.conditions.folder);
  add(run.conditions.out_path);
  const auto& limit = run.conditions.largest_file_bytes;
  add(limit ? std::to_string(*limit) : "");
  for (const auto& argument : run.arguments) add(argument);
  if (text.size() > kLongest) return false;
  Message message(text.data(), text.size());
  cmsghdr* const beside = CMSG_FIRSTHDR(&message.header);
  beside->cmsg_level = SOL_SOCKET;
  beside->cmsg_type = SCM_RIGHTS;
  beside->cmsg_len = CMSG_LEN(sizeof(Descriptors));
  const Descriptors descriptors{run.out, run.err};
  std::memcpy(CMSG_DATA(beside), descriptors.data(), sizeof descriptors);
  return ::sendmsg(socket, &message.header, MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
}

std::optional<AskedRun> asked_run(int socket) {
  std::string text(kLongest, ' ');
  Message message(text.data(), text.size());
  const ssize_t size = ::recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC);
  if (size <= 0) return std::nullopt;
  text.resize(static_cast<std::size_t>(size));
  std::vector<std::string> parts;
  for (std::size_t at = 0; at < text.size(); at += parts.back().size() + 1)
    parts.push_back(text.substr(at, text.find('\0', at) - at));
  AskedRun run{{parts.begin() + 3, parts.end()}, {parts[0], {}, parts[1]}};
  if (!parts[2].empty()) run.conditions.largest_file_bytes = std::stoull(parts[2]);
  Descriptors descriptors{};
  std::memcpy(descriptors.data(), CMSG_DATA(CMSG_FIRSTHDR(&message.header)), sizeof descriptors);
  run.out = descriptors[0];
  run.err = descriptors[1];
  return run;
}

} // namespace orograph
