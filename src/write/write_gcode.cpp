// SPDX-License-Identifier: GPL-3.0-or-later
// G-code: straight moves in absolute coordinates; what lifts and lowers the pen are the machine's
// own lines.
#include "geometry/error.hpp"
#include "write/device_words.hpp"
#include "write/draw_on_device.hpp"
#include "write/format_text.hpp"
#include "write/writers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orograph {
namespace {

class GcodeText {
public:
  GcodeText(const Device& device, const OnDevice& on_device, ByteSink& out)
      : device_(device), on_device_(on_device), out_(out), feed_(page_number(device.feed_mm_min)) {
    say(device.start);
  }

  void take_pen(const std::optional<Pen>& pen) {
    const int number = pen ? pen->number : 1;
    const bool is_first = !in_hand_;
    if (number != in_hand_ && (!is_first || (pen && pen->waits))) {
      lift();
      for (const std::string& line : device_.wait)
        add(filled(line,
                   {{"pen", std::to_string(number)}, {"name", pen ? plain_words(pen->name) : ""}}));
      at_.reset(); // whoever changes a pen may move it
    }
    in_hand_ = number;
    feed_ = page_number(pen && pen->speed_mm_s ? 60 * *pen->speed_mm_s : device_.feed_mm_min);
    const double percent =
        pen && pen->height_percent ? *pen->height_percent : device_.height_percent;
    height_ =
        page_number(device_.heights.x + percent / 100 * (device_.heights.y - device_.heights.x));
  }

  void draw(std::span<const Vec2> page_mm) {
    const std::vector<DeviceStep> points = on_device_.steps(page_mm);
    if (!at_ || *at_ != points.front()) {
      lift();
      add(moved(device_.travel, points.front()));
    }
    if (!is_down_) {
      for (const std::string& line : device_.pen_down)
        add(filled(line, {{"height", height_}, {"feed", feed_}}));
      is_down_ = true;
      feeds_ = false;
    }
    for (std::size_t i = points.size() == 1 ? 0 : 1; i < points.size(); ++i) {
      std::string line = moved(device_.draw, points[i]);
      // What lowers the pen may have another.
      if (!feeds_ && device_.draw.find("{feed}") == std::string::npos) line += " F" + feed_;
      feeds_ = true;
      add(line);
    }
    at_ = points.back();
  }

  void end() {
    lift();
    say(device_.end);
    out_.append(text_);
  }

  /// Whether more is wanted.
  bool hand_on() {
    const bool is_taken = out_.append(text_);
    text_.clear();
    return is_taken;
  }

private:
  void lift() {
    if (is_down_ || !was_lifted_)
      for (const std::string& line : device_.pen_up) add(filled(line, {{"feed", feed_}}));
    is_down_ = false;
    was_lifted_ = true;
  }
  std::string coordinate(std::int64_t steps) const {
    return page_number(static_cast<double>(steps) / std::pow(10, device_.decimals));
  }
  std::string moved(const std::string& words, DeviceStep to) const {
    return filled(words, {{"x", coordinate(to.x)}, {"y", coordinate(to.y)}, {"feed", feed_}});
  }
  void say(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) add(line);
  }
  void add(const std::string& line) {
    if (line.size() > device_.longest)
      throw Error(fmt::format("the line '{}' is longer than the {} bytes of the {}", line,
                              device_.longest, device_.name),
                  "give the device shorter words, or a greater longest", ErrorCode::request);
    text_ += line;
    text_ += '\n';
  }

  const Device& device_;
  const OnDevice& on_device_;
  ByteSink& out_;
  std::string text_, feed_, height_;
  bool is_down_ = false, feeds_ = false, was_lifted_ = false;
  std::optional<int> in_hand_;
  std::optional<DeviceStep> at_;
};

} // namespace

void write_gcode(const Drawing& drawing, const Device& device, const OnDevice& on_device,
                 ByteSink& out) {
  GcodeText text(device, on_device, out);
  draw_on_device(drawing, text);
}

} // namespace orograph
