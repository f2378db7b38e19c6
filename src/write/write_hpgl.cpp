// SPDX-License-Identifier: GPL-3.0-or-later
// HPGL: points are snapped to the plotter's units before their differences are taken, so that these
// add up to where the pen should be.
#include "geometry/error.hpp"
#include "write/device_words.hpp"
#include "write/draw_on_device.hpp"
#include "write/writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace orograph {
namespace {

class HpglText {
public:
  HpglText(const Device& device, const OnDevice& on_device, ByteSink& out)
      : device_(device), on_device_(on_device), out_(out) {}

  void say(const std::vector<std::string>& words) {
    for (const std::string& word : words) text_ += word;
  }
  void say(const std::string& word) { text_ += word; }

  void take_pen(const std::optional<Pen>& pen) {
    const int number = pen ? pen->number : 1;
    const bool is_first = !in_hand_;
    if (in_hand_ != number) {
      if (!is_first) text_ += "PU;";
      if (pen && pen->waits)
        for (const std::string& word : device_.wait)
          text_ +=
              filled(word, {{"pen", std::to_string(number)}, {"name", plain_words(pen->name)}});
      text_ += fmt::format("SP{};", number);
      in_hand_ = number;
    }
    if (!device_.speeds_cm_s) return;
    const Vec2 range = *device_.speeds_cm_s;
    std::optional<int> speed;
    if (pen && pen->speed_mm_s)
      speed = static_cast<int>(
          std::lround(std::clamp(std::round(*pen->speed_mm_s / 10), range.x, range.y)));
    if (speed == speed_) return;
    text_ += speed ? fmt::format("VS{};", *speed) : "VS;"; // which is the plotter's own
    speed_ = speed;
  }

  void draw(std::span<const Vec2> page_mm) {
    const std::vector<DeviceStep> points = on_device_.steps(page_mm);
    if (at_ != points.front()) text_ += fmt::format("PU{},{};", points.front().x, points.front().y);
    at_ = points.front();
    if (device_.relative) text_ += "PR;";
    begin_ = text_.size();
    text_ += "PD";
    // A dot is drawn by going nowhere.
    for (std::size_t i = points.size() == 1 ? 0 : 1; i < points.size(); ++i) add(points[i]);
    text_ += ";";
    if (device_.relative) text_ += "PA;";
  }

  /// Whether more is wanted.
  bool hand_on() {
    const bool is_taken = out_.append(text_);
    text_.clear();
    return is_taken;
  }

  void end() {
    text_ += "PU;";
    const DevicePaper* const paper = on_device_.paper();
    if (paper != nullptr && paper->park)
      text_ += fmt::format("PU{:.0f},{:.0f};", paper->park->x, paper->park->y);
    say(device_.end);
    text_ += "\n";
    out_.append(text_);
  }

private:
  void add(DeviceStep to) {
    const DeviceStep from = device_.relative ? *at_ : DeviceStep{};
    const std::string pair = fmt::format("{},{}", to.x - from.x, to.y - from.y);
    const bool is_first = text_.size() == begin_ + 2;
    if (!is_first && text_.size() - begin_ + pair.size() + 2 > device_.longest) {
      text_ += ";";
      begin_ = text_.size();
      text_ += "PD";
    } else if (!is_first) {
      text_ += ",";
    }
    text_ += pair;
    at_ = to;
  }

  const Device& device_;
  const OnDevice& on_device_;
  ByteSink& out_;
  std::string text_;
  std::size_t begin_ = 0; ///< of the instruction that grows
  std::optional<int> in_hand_, speed_;
  std::optional<DeviceStep> at_;
};

void check_pens(const Drawing& drawing, const Device& device) {
  for (const Layer& layer : drawing.layers) {
    if (layer.is_pen_way || !layer.pen) continue;
    if (layer.pen->number > device.pens.value_or(layer.pen->number))
      throw UsageError(fmt::format("pen {} of the {}, which has {}", layer.pen->number, device.name,
                                   *device.pens),
                       fmt::format("give `pens` numbers up to {}", *device.pens));
    if (layer.pen->waits && device.wait.empty())
      throw UsageError(fmt::format("the {} has no word to wait for a pen", device.name),
                       "give a device with the key wait, or pens without it");
  }
}

} // namespace

void write_hpgl(const Drawing& drawing, const Device& device, const OnDevice& on_device,
                ByteSink& out) {
  check_pens(drawing, device);
  HpglText text(device, on_device, out);
  text.say(device.start);
  if (const DevicePaper* paper = on_device.paper()) text.say(paper->choose);
  draw_on_device(drawing, text);
}

} // namespace orograph
