# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep's page in headless Chromium, from file://: what it shows and how it answers.
usage: page_test.py MAKE_PAGES"""

import pathlib
import re
import subprocess
import sys
import tempfile
import time

from browser import Browser

failures = []


def check(what, is_so, *seen):
    if not is_so:
        failures.append(what)
        print("FAILED:", what, *seen)


def expect(what, seen, wanted):
    check(what, seen == wanted, f"is {seen!r}, should be {wanted!r}")


def open_page(browser, folder, name, state=""):
    browser.open(f"file://{folder}/{name}.html{state}")
    browser.wait("document.documentElement.dataset.ready === 'true'")


def text(browser, selector):
    return browser.run("document.querySelector(arguments[0]).textContent", selector)


def number(browser, column):
    return text(browser, f'dd[data-column="{column}"]')


def name(browser):
    return text(browser, "#view-name")


def ink(browser, selector):
    """How many pixels of a canvas have ink."""
    return browser.run("""((canvas) => canvas.width * canvas.height === 0 ? 0 :
        canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data
        .filter((value, i) => i % 4 === 3 && value > 20).length)(document.querySelector(arguments[0]))""", selector)


def choose(browser, selector, value):
    """Moves a slider or makes a choice as a hand would, events and all."""
    browser.run("""((control) => { control.value = arguments[1]; for (const kind of ['input', 'change'])
        control.dispatchEvent(new Event(kind, {bubbles: true})); })(document.querySelector(arguments[0]))""",
                selector, value)


def points(browser):
    return browser.run("document.querySelectorAll('#plot circle.point').length")


def check_quiet(browser, page):
    """Nothing on the console, and nothing asked for but files beside the page."""
    expect(f"{page}: console", browser.log("browser"), [])
    asked = [url for url in browser.requests() if not url.startswith(("file:///", "data:,", "about:"))]
    expect(f"{page}: requests", asked, [])


def check_source(folder):
    """What the file names: no address but names of XML, and the data between its own two tags."""
    for page in ("one", "crossed", "zipped"):
        source = pathlib.Path(folder, page + ".html").read_text(encoding="utf-8")
        outside = re.sub(r'(<script type="application/json"[^>]*>).*?</script>', "", source, flags=re.S)
        expect(f"{page}: addresses", set(re.findall(r"https?://[^\s'\"`)]+", outside)) - {"http://www.w3.org/2000/svg"}, set())
        expect(f"{page}: links", re.findall(r"(?:src|href)\s*=\s*\"([^\"]*)\"", outside), ["data:,"])
        expect(f"{page}: imports", re.findall(r"@import|url\(|\bimport\s|fetch\(|XMLHttp|innerHTML|eval\(", outside), [])
        expect(f"{page}: scripts", source.count("</script"), 3)


def check_one(browser, folder):
    open_page(browser, folder, "one")
    expect("one: heading", text(browser, "h1"), "one.tif")
    expect("one: summary", text(browser, "#summary"), "1 view")
    expect("one: sliders", browser.run("document.querySelectorAll('input[type=range]').length"), 0)
    check("one: the view is drawn", ink(browser, "#drawing") > 1000)
    expect("one: strokes", number(browser, "strokes"), "1000")
    expect("one: length", number(browser, "pen_down_mm"), "12\u202f346 mm")
    browser.press("right", "space", "up")
    expect("one: keys do nothing", name(browser), "view-000")
    check_quiet(browser, "one")


def check_sliders(browser):
    expect("crossed: sliders", browser.run("[...document.querySelectorAll('input[type=range]')].map((s) => s.dataset.axis)"),
           ["azimuth_deg", "elevation_deg"])
    before = browser.run("document.getElementById('drawing').toDataURL()")
    choose(browser, "#slider-0", 4)  # 60 degrees
    expect("slider: view", name(browser), "view-012")
    expect("slider: azimuth", number(browser, "azimuth_deg"), "60°")
    expect("slider: strokes", number(browser, "strokes"), "1084")
    expect("slider: said", text(browser, ".control output"), "60°")
    check("slider: another drawing", before != browser.run("document.getElementById('drawing').toDataURL()"))
    choose(browser, "#slider-1", 2)
    expect("second slider: view", name(browser), "view-014")
    expect("second slider: elevation", number(browser, "elevation_deg"), "45°")
    choose(browser, "#slider-1", 1)
    choose(browser, "#slider-0", 13)  # view 40 isn't there: the next on the way
    expect("slider: over a missing view", name(browser), "view-043")
    expect("slider: stands where the view is", browser.run("document.getElementById('slider-0').value"), "14")


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
    expect("play: button says so", browser.run("document.querySelector('.play').ariaLabel"), "Pause azimuth")
    browser.press("space")
    check("play: space stops", rests(browser))
    elevation = number(browser, "elevation_deg")
    browser.click(".control:nth-child(1) .play")
    check("play: button turns", turns(browser))
    expect("play: turns one axis", number(browser, "elevation_deg"), elevation)
    browser.click(".control:nth-child(1) .play")
    check("play: button stops", rests(browser))


def check_drag(browser):
    choose(browser, "#slider-1", 0)
    choose(browser, "#slider-0", 12)
    browser.drag("#sheet", 0.75, 0.25)
    expect("drag: half the drawing, half a turn", number(browser, "azimuth_deg"), "0°")


def check_thumbnails(browser):
    expect("thumbnails: all", browser.run("document.querySelectorAll('.thumbnail').length"), 71)
    expect("thumbnails: groups", browser.run("[...document.querySelectorAll('h3')].map((h) => h.textContent)"),
           ["elevation 10°", "elevation 25°", "elevation 45°"])
    browser.click("#thumbnails div:nth-child(3) li:nth-child(5) .thumbnail")
    expect("thumbnail: view", name(browser), "view-014")
    expect("thumbnail: slider", browser.run("document.getElementById('slider-0').value"), "4")
    expect("thumbnail: marked", browser.run("[...document.querySelectorAll('[aria-current]')].map((e) => e.title)"), ["view-014"])
    browser.wait("document.querySelector('[aria-current] canvas').dataset.drawn !== undefined")
    check("thumbnail: drawn", ink(browser, "[aria-current] canvas") > 100)
    browser.press("right")
    expect("thumbnail: focus goes along", browser.run("document.activeElement.title"), "view-017")


def check_plot(browser):
    expect("plot: measures", browser.run("[...document.getElementById('plot-y').options].map((o) => o.value)"),
           ["azimuth_deg", "elevation_deg", "strokes", "visible_share", "pen_down_mm", "seconds"])
    expect("plot: parameters", browser.run("[...document.getElementById('plot-x').options].map((o) => o.value)"),
           ["azimuth_deg", "elevation_deg", "view"])
    expect("plot: points", points(browser), 71)
    lines = "document.querySelectorAll('#plot .line').length"
    expect("plot: a line an elevation", browser.run(lines), 3)
    choose(browser, "#plot-x", "elevation_deg")
    expect("plot: a line an azimuth", browser.run(lines), 24)
    choose(browser, "#plot-x", "view")
    expect("plot: one line of views", browser.run(lines), 1)
    choose(browser, "#plot-y", "pen_down_mm")
    expect("plot: names", browser.run("[...document.querySelectorAll('#plot .name')].map((n) => n.textContent)"), ["pen down, mm", "view"])
    expect("plot: about", text(browser, "#plot-about"), "length drawn")
    choose(browser, "#plot-x", "azimuth_deg")
    choose(browser, "#plot-y", "seconds")
    check_plot_places(browser)
    browser.click(".numbers button[aria-pressed=false]")
    expect("plot: by a number's name", browser.run("document.getElementById('plot-y').value"), "azimuth_deg")
    choose(browser, "#plot-y", "seconds")


def check_plot_places(browser):
    """Points stand where their values are; the ticks tell the scale."""
    ticks = browser.run("""[...document.querySelectorAll('#plot .grid')].map((line, i) =>
        [Number(document.querySelectorAll('#plot .y-tick')[i].textContent), Number(line.getAttribute('y1'))])""")
    (low, low_y), (high, high_y) = ticks[0], ticks[-1]
    group = browser.run("[...document.querySelectorAll('#plot .line.current circle.point')].map((c) => [+c.getAttribute('cx'), +c.getAttribute('cy')])")
    for place, (x, y) in enumerate(group):  # azimuth by azimuth, elevation 45: views 2, 5, 8...
        seconds = 0.25 + 0.001 * (3 * place + 2)
        check("plot: height of a point", abs(low_y + (seconds - low) / (high - low) * (high_y - low_y) - y) < 0.2, place, y)
    steps = [b[0] - a[0] for a, b in zip(group, group[1:])]
    check("plot: even azimuths", len(group) == 24 and max(steps) - min(steps) < 0.3, steps)
    browser.run("document.getElementById('plot').scrollIntoView({block: 'center'})")
    x, y = browser.run("((box) => [box.x, box.y])(document.querySelector('#plot svg').getBoundingClientRect())")
    there = [{"type": "pointerMove", "duration": 0, "x": round(x + group[20][0]), "y": round(y + group[20][1])}]
    browser.act_pointer(there)
    expect("plot: readout", text(browser, ".readout"), "0.312 sazimuth 300°, elevation 45°")
    press = [{"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}]
    browser.act_pointer(there + press)
    expect("plot: click selects", name(browser), "view-062")
    mark = browser.run("((m) => [+m.getAttribute('cx'), +m.getAttribute('cy')])(document.querySelector('#plot .mark'))")
    check("plot: mark at the view", max(abs(a - b) for a, b in zip(mark, group[20])) < 0.1, mark)


def check_address(browser, folder):
    browser.wait("location.hash === '#view=62&x=azimuth_deg&y=seconds'")
    open_page(browser, folder, "crossed", "#view=33&x=view&y=strokes")
    expect("address: view", name(browser), "view-033")
    expect("address: x, y", browser.run("[document.getElementById('plot-x').value, document.getElementById('plot-y').value]"), ["view", "strokes"])
    browser.run("location.hash = '#view=5&x=elevation_deg&y=seconds'")
    browser.wait("document.getElementById('view-name').textContent === 'view-005'")
    expect("address: changed", browser.run("document.getElementById('plot-x').value"), "elevation_deg")
    for wrong in ("#view=40", "#view=1e9&x=nowhere&y=<b>", "#%%%"):
        open_page(browser, folder, "crossed", wrong)
        expect(f"address: {wrong}", name(browser), "view-000")


def check_full(browser):
    """The drawing's own file, where it can be read."""
    browser.click("#full-switch")
    browser.wait("document.getElementById('full-drawing').naturalWidth > 0")
    check("full: in place of the preview", browser.run("!document.getElementById('full-drawing').hidden"))
    expect("full: link", browser.run("document.getElementById('full-link').getAttribute('href')"), "./view-000.svg")
    browser.wait("location.hash.includes('full=1')")
    browser.click("#full-switch")
    check("full: and back", browser.run("document.getElementById('full-drawing').hidden"))


def check_full_missing(browser):
    """A file that isn't there any more is said to be missing; the preview stays."""
    browser.click("#full-switch")
    choose(browser, "#slider-0", 1)
    browser.wait("document.getElementById('sheet-message').textContent.startsWith('view-003.svg can’t be read')")
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


def check_zipped(browser, folder):
    open_page(browser, folder, "zipped")
    expect("zipped: summary", text(browser, "#summary"), "360 views · 40 failed")
    hostile = text(browser, "h1")
    check("zipped: hostile heading", hostile.startswith("</script><b id=\"broken\">&amp;<!--") and hostile.endswith("\\ Ñandú 山岳"), hostile)
    expect("zipped: nothing broke out", browser.run("document.querySelectorAll('#broken, main script').length"), 0)
    expect("zipped: title", browser.run("document.title"), hostile + " – sweep")
    expect("zipped: text column", number(browser, "projection"), hostile)
    expect("zipped: sliders", browser.run("[...document.querySelectorAll('input[type=range]')].map((s) => s.dataset.axis)"), ["view"])
    check_lazy(browser)
    choose(browser, "#plot-y", "seconds")
    expect("zipped: points", points(browser), 320)
    gaps = browser.run("document.querySelector('#plot .line path').getAttribute('d').match(/M/g).length")
    expect("zipped: the line breaks at failed views", gaps, 41)
    choose(browser, "#slider-0", 4)
    expect("failed: said", text(browser, "#sheet-message"), "This view failed: no room: " + hostile)
    expect("failed: no number", number(browser, "seconds"), "–")
    check("failed: no drawing, no link", browser.run("document.getElementById('drawing').hidden && document.getElementById('full-link').hidden"))
    choose(browser, "#slider-0", 5)
    check("failed: over", browser.run("document.getElementById('sheet-message').hidden") and ink(browser, "#drawing") > 1000)
    link = browser.run("document.getElementById('full-link').href")
    check("zipped: link stays beside the page", link.startswith(f"file://{folder}/javascript%3A5%20%23%3F%25%3C"), link)
    check_quiet(browser, "zipped")


def check_lazy(browser):
    drawn = "document.querySelectorAll('canvas[data-drawn]').length"
    inked = "[...document.querySelectorAll('.thumbnail canvas')].filter((c) => c.dataset.drawn !== undefined && c.width > 0).length"
    browser.run("document.querySelector('.thumbnail').scrollIntoView()")
    count = browser.wait(drawn)
    check("lazy: some thumbnails are drawn, not all", 5 < count < 100, count)
    browser.run("document.querySelectorAll('.thumbnail')[300].scrollIntoView()")
    browser.wait("document.querySelectorAll('.thumbnail')[300].querySelector('canvas').dataset.drawn !== undefined")
    browser.wait("document.querySelector('.thumbnail canvas').dataset.drawn === undefined")
    check("lazy: those left are cleared", browser.run(inked) < 100 and ink(browser, ".thumbnail canvas") == 0)
    browser.run("window.scrollTo(0, 0)")


def check_looks(browser, folder):
    """Both colour schemes, and no sideways scrolling at any width."""
    papers = []
    for scheme in ("light", "dark"):
        browser.set_media(prefers_color_scheme=scheme)
        for page in ("one", "crossed", "zipped"):
            open_page(browser, folder, page)
            for width in (320, 390, 1000, 1600) if scheme == "light" else (390, 1600):
                browser.resize(width, 844)
                browser.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")
                check(f"{page}: no sideways scrolling at {width} {scheme}",
                      browser.run("document.documentElement.scrollWidth <= innerWidth"),
                      browser.run("[document.documentElement.scrollWidth, innerWidth]"))
        papers.append(browser.run("[getComputedStyle(document.getElementById('sheet')).backgroundColor, getComputedStyle(document.body).color]"))
    check("looks: dark is another paper and ink", papers[0][0] != papers[1][0] and papers[0][1] != papers[1][1], papers)
    browser.set_media(prefers_color_scheme="light")


def check_phone(folder):
    with Browser(phone=True) as phone:
        open_page(phone, folder, "crossed")
        check("phone: no sideways scrolling", phone.run("document.documentElement.scrollWidth <= innerWidth && innerWidth === 390"))
        small = phone.run("""[...document.querySelectorAll('.play, select, .thumbnail, .switch')]
            .filter((e) => Math.min(e.offsetWidth, e.offsetHeight) < 40).map((e) => e.className || e.id)""")
        expect("phone: controls for thumbs", small, [])
        expect("phone: as sharp as the screen", phone.run("document.getElementById('drawing').width"), 3 * 390)
        phone.drag("#sheet", 0.75, 0.25, "touch")
        expect("phone: a finger turns the view", number(phone, "azimuth_deg"), "180°")
        phone.run("window.scrollTo(0, 1500)")
        check("phone: the drawing stays in sight", phone.run("document.getElementById('sheet').getBoundingClientRect().top === 0"))
        check_quiet(phone, "phone")


def main():
    with tempfile.TemporaryDirectory(prefix="orograph-test-") as folder:
        subprocess.run([sys.argv[1], folder], check=True)
        check_source(folder)
        with Browser() as browser:
            browser.resize(1600, 1000)
            check_one(browser, folder)
            check_crossed(browser, folder)
            check_zipped(browser, folder)
            check_looks(browser, folder)
        check_phone(folder)
    print(f"{len(failures)} checks failed" if failures else "all as it should be")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
