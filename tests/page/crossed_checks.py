# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of a crossed sweep: everything that turns the view, and everything that follows it."""

import time

from seen import (check, check_quiet, choose, count, expect, ink, name, number, open_page, points,
                  text, texts, value, values)


def check_sliders(browser):
    expect("crossed: sliders", values(browser, "input[type=range]", "axis"),
           ["azimuth_deg", "elevation_deg"])
    before = browser.run("document.getElementById('drawing').toDataURL()")
    choose(browser, "#slider-0", 4)  # 60 degrees
    expect("slider: view", name(browser), "view-012")
    expect("slider: azimuth", number(browser, "azimuth_deg"), "60°")
    expect("slider: strokes", number(browser, "strokes"), "1084")
    expect("slider: said", text(browser, ".control output"), "60°")
    after = browser.run("document.getElementById('drawing').toDataURL()")
    check("slider: another drawing", before != after)
    choose(browser, "#slider-1", 2)
    expect("second slider: view", name(browser), "view-014")
    expect("second slider: elevation", number(browser, "elevation_deg"), "45°")
    choose(browser, "#slider-1", 1)
    choose(browser, "#slider-0", 13)  # view 40 isn't there: the next on the way
    expect("slider: over a missing view", name(browser), "view-043")
    expect("slider: stands where the view is", value(browser, "#slider-0", "value"), "14")


def check_keys(browser):
    choose(browser, "#slider-1", 0)
    choose(browser, "#slider-0", 0)
    browser.run("document.activeElement.blur()")
    browser.press("right", "right")
    expect("keys: right", name(browser), "view-006")
    browser.press("left", "left", "left")
    expect("keys: left, round the end", name(browser), "view-069")
    browser.press("up")
    expect("keys: up", name(browser), "view-070")
    browser.press("down")
    expect("keys: down", name(browser), "view-069")
    browser.run("document.getElementById('slider-1').focus()")
    browser.press("right")
    expect("keys: a slider's own", name(browser), "view-070")
    browser.run("document.getElementById('plot-y').focus()")
    browser.press("left")
    expect("keys: a choice's own", name(browser), "view-070")
    browser.run("document.activeElement.blur()")


def turns(browser):
    """Whether it goes on by itself: two other views than this one."""
    seen = {name(browser)}
    end = time.monotonic() + 3
    while len(seen) < 3 and time.monotonic() < end:
        seen.add(name(browser))
        time.sleep(0.02)
    return len(seen) >= 3


def rests(browser):
    before = name(browser)
    time.sleep(0.4)
    return name(browser) == before


def check_play(browser):
    browser.press("space")
    check("play: space turns", turns(browser))
    expect("play: button says so", value(browser, ".play", "ariaLabel"), "Pause azimuth")
    browser.press("space")
    check("play: space stops", rests(browser))
    elevation = number(browser, "elevation_deg")
    browser.click(".control:nth-child(1) .play")
    check("play: button turns", turns(browser))
    expect("play: turns one axis", number(browser, "elevation_deg"), elevation)
    browser.click(".control:nth-child(1) .play")
    check("play: button stops", rests(browser))
    check_calm_play(browser)


def check_calm_play(browser):
    """Where less motion is wished for, it turns slowly."""
    browser.set_media(prefers_reduced_motion="reduce")
    browser.run("window.steps = 0")
    browser.run("""new MutationObserver(() => ++window.steps)
        .observe(document.getElementById('view-name'), {childList: true})""")
    browser.press("space")
    browser.wait("window.steps >= 1")
    begin = time.monotonic()
    browser.wait("window.steps >= 3")
    check("play: calm", time.monotonic() - begin > 0.5)
    browser.press("space")
    browser.set_media(prefers_reduced_motion="no-preference")


def check_drag(browser):
    choose(browser, "#slider-1", 0)
    choose(browser, "#slider-0", 12)
    browser.drag("#sheet", 0.75, 0.5)
    expect("drag: a quarter of the drawing, a quarter turn", number(browser, "azimuth_deg"), "270°")


def check_thumbnails(browser):
    expect("thumbnails: all", count(browser, ".thumbnail"), 71)
    expect("thumbnails: chosen", values(browser, ".thumbnail.chosen", "title"),
           ["view-046: shows most of the terrain"])
    expect("thumbnails: groups", texts(browser, "h3"),
           ["elevation 10°", "elevation 25°", "elevation 45°"])
    browser.click("#thumbnails div:nth-child(3) li:nth-child(5) .thumbnail")
    expect("thumbnail: view", name(browser), "view-014")
    expect("thumbnail: slider", value(browser, "#slider-0", "value"), "4")
    expect("thumbnail: marked", values(browser, "[aria-current]", "title"), ["view-014"])
    browser.wait("document.querySelector('[aria-current] canvas').dataset.drawn !== undefined")
    check("thumbnail: drawn", ink(browser, "[aria-current] canvas") > 100)
    browser.press("right")
    expect("thumbnail: focus goes along", browser.run("document.activeElement.title"), "view-017")


def check_plot(browser):
    expect("plot: measures", values(browser, "#plot-y option", "value"),
           ["azimuth_deg", "elevation_deg", "strokes", "visible_share", "pen_down_mm", "seconds"])
    expect("plot: parameters", values(browser, "#plot-x option", "value"),
           ["azimuth_deg", "elevation_deg", "view"])
    expect("plot: points", points(browser), 71)
    expect("plot: a line an elevation", count(browser, "#plot .line"), 3)
    choose(browser, "#plot-x", "elevation_deg")
    expect("plot: a line an azimuth", count(browser, "#plot .line"), 24)
    choose(browser, "#plot-x", "view")
    expect("plot: one line of views", count(browser, "#plot .line"), 1)
    choose(browser, "#plot-y", "pen_down_mm")
    expect("plot: names", texts(browser, "#plot .name"), ["pen down, mm", "view"])
    expect("plot: about", text(browser, "#plot-about"), "length drawn")
    choose(browser, "#plot-x", "azimuth_deg")
    choose(browser, "#plot-y", "seconds")
    check_plot_places(browser)
    browser.click(".numbers button[aria-pressed=false]")
    expect("plot: by a number's name", value(browser, "#plot-y", "value"), "azimuth_deg")
    choose(browser, "#plot-y", "seconds")


def centres(browser, selector):
    return browser.run("""[...document.querySelectorAll(arguments[0])]
        .map((circle) => [+circle.getAttribute('cx'), +circle.getAttribute('cy')])""", selector)


def check_plot_places(browser):
    """Points stand where their values are; the ticks tell the scale."""
    ticks = browser.run("""[...document.querySelectorAll('#plot .grid')].map((line, i) =>
        [Number(document.querySelectorAll('#plot .y-tick')[i].textContent),
         Number(line.getAttribute('y1'))])""")
    (low, low_y), (high, high_y) = ticks[0], ticks[-1]
    check("plot: more is higher", high > low and high_y < low_y, ticks)
    group = centres(browser, "#plot .line.current circle.point")
    for place, (x, y) in enumerate(group):  # azimuth by azimuth, elevation 45: views 2, 5, 8...
        seconds = 0.25 + 0.001 * (3 * place + 2)
        wanted_y = low_y + (seconds - low) / (high - low) * (high_y - low_y)
        check("plot: height of a point", abs(wanted_y - y) < 0.2, place, y, wanted_y)
    steps = [b[0] - a[0] for a, b in zip(group, group[1:])]
    even = min(steps) > 0 and max(steps) - min(steps) < 0.3
    check("plot: even azimuths", len(group) == 24 and even, steps)
    browser.run("document.getElementById('plot').scrollIntoView({block: 'center'})")
    x, y = browser.run("""(({x, y}) => [x, y])
        (document.querySelector('#plot svg').getBoundingClientRect())""")
    there = browser.move_to(x + group[20][0], y + group[20][1])
    browser.point([there])
    expect("plot: readout", text(browser, ".readout"), "0.312 sazimuth 300°, elevation 45°")
    browser.point([there, browser.DOWN, browser.UP])
    expect("plot: click selects", name(browser), "view-062")
    mark = centres(browser, "#plot .mark")[0]
    check("plot: mark at the view", max(abs(a - b) for a, b in zip(mark, group[20])) < 0.1, mark)


def check_address(browser, folder):
    browser.wait("location.hash === '#view=62&x=azimuth_deg&y=seconds'")
    open_page(browser, folder, "crossed", "#view=33&x=view&y=strokes")
    expect("address: view", name(browser), "view-033")
    expect("address: x, y", values(browser, "#plot-y, #plot-x", "value"), ["strokes", "view"])
    browser.run("location.hash = '#view=5&x=elevation_deg&y=seconds'")
    browser.wait("document.getElementById('view-name').textContent === 'view-005'")
    expect("address: changed", value(browser, "#plot-x", "value"), "elevation_deg")
    for wrong in ("#view=40", "#view=1e9&x=nowhere&y=<b>", "#%%%"):
        open_page(browser, folder, "crossed", wrong)
        expect(f"address: {wrong}", name(browser), "view-000")


def check_full(browser):
    """The drawing's own file, where it can be read."""
    browser.click("#full-switch")
    browser.wait("document.getElementById('full-drawing').naturalWidth > 0")
    check("full: in place of the preview", not value(browser, "#full-drawing", "hidden"))
    link = browser.run("document.getElementById('full-link').getAttribute('href')")
    expect("full: link", link, "./view-000.svg")
    browser.wait("location.hash.includes('full=1')")
    browser.click("#full-switch")
    check("full: and back", value(browser, "#full-drawing", "hidden"))


def check_full_missing(browser):
    """A file that isn't there any more is said to be missing; the preview stays."""
    browser.click("#full-switch")
    choose(browser, "#slider-0", 1)
    browser.wait("""document.getElementById('sheet-message').textContent
        .startsWith('view-003.svg can’t be read')""")
    check("full: the preview stays", ink(browser, "#drawing") > 1000)


def check_crossed(browser, folder):
    open_page(browser, folder, "crossed")
    expect("crossed: summary", text(browser, "#summary"), "71 views · 1 not in this table")
    expect("crossed: view", name(browser), "view-000")
    check("crossed: drawn", ink(browser, "#drawing") > 1000)
    for part in (check_sliders, check_keys, check_play, check_drag, check_thumbnails, check_plot):
        part(browser)
    check_quiet(browser, "crossed")
    check_address(browser, folder)
    check_full(browser)
    check_quiet(browser, "crossed, other addresses")
    check_full_missing(browser)
