# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep's page in headless Chromium, from file://: what it shows and how it answers.
usage: page_test.py MAKE_PAGES"""

import pathlib
import re
import subprocess
import sys
import tempfile

from browser import Browser
from crossed_checks import check_crossed
from seen import (check, check_quiet, choose, count, expect, failures, ink, name, number, open_page,
                  points, text, value, values)


def check_source(folder):
    """What the file names: no address but names of XML, and the data between its own two tags."""
    for page in ("empty", "one", "crossed", "zipped"):
        source = pathlib.Path(folder, page + ".html").read_text(encoding="utf-8")
        data = r'(<script type="application/json"[^>]*>).*?</script>'
        outside = re.sub(data, "", source, flags=re.S)
        addresses = set(re.findall(r"https?://[^\s'\"`)]+", outside))
        expect(f"{page}: addresses", addresses, {"http://www.w3.org/2000/svg"})
        links = re.findall(r"(?:src|href)\s*=\s*\"([^\"]*)\"", outside)
        expect(f"{page}: links", links, ["data:,"])
        fetched = r"@import|url\(|\bimport\s|fetch\(|XMLHttp|innerHTML|eval\("
        expect(f"{page}: imports", re.findall(fetched, outside), [])
        expect(f"{page}: scripts", source.count("</script"), 3)


def check_one(browser, folder):
    open_page(browser, folder, "one")
    expect("one: heading", text(browser, "h1"), "one.tif")
    expect("one: summary", text(browser, "#summary"), "1 view")
    expect("one: sliders", count(browser, "input[type=range]"), 0)
    check("one: the view is drawn", ink(browser, "#drawing") > 1000)
    expect("one: strokes", number(browser, "strokes"), "1000")
    expect("one: length", number(browser, "pen_down_mm"), "12\u202f346 mm")
    browser.press("right", "space", "up")
    expect("one: keys do nothing", name(browser), "view-000")
    check_quiet(browser, "one")


def check_empty(browser, folder):
    """A shard without views."""
    open_page(browser, folder, "empty")
    expect("empty: summary", text(browser, "#summary"), "0 views · 5 not in this table")
    check("empty: nothing else", value(browser, "main", "hidden"))
    check_quiet(browser, "empty")


def check_zipped(browser, folder):
    open_page(browser, folder, "zipped")
    expect("zipped: summary", text(browser, "#summary"), "360 views · 40 failed")
    hostile = text(browser, "h1")
    expect("zipped: hostile heading", hostile, "</script><b id=\"broken\">&amp;<!--<script>"
           "alert('{{previews}}{{table}}')</script>\"\\ Ñandú 山岳")
    expect("zipped: nothing broke out", count(browser, "#broken, main script"), 0)
    expect("zipped: title", browser.run("document.title"), hostile + " – sweep")
    expect("zipped: text column", number(browser, "projection"), hostile)
    expect("zipped: sliders", values(browser, "input[type=range]", "axis"), ["view"])
    check_lazy(browser)
    choose(browser, "#plot-y", "seconds")
    expect("zipped: points", points(browser), 320)
    gaps = browser.run("""document.querySelector('#plot .line path').getAttribute('d')
        .match(/M/g).length""")
    expect("zipped: the line breaks at failed views", gaps, 41)
    choose(browser, "#slider-0", 4)
    expect("failed: said", text(browser, "#sheet-message"), "This view failed: no room: " + hostile)
    expect("failed: no number", number(browser, "seconds"), "–")
    expect("failed: no drawing, no link", values(browser, "#drawing, #full-link", "hidden"),
           [True, True])
    choose(browser, "#slider-0", 5)
    check("failed: over", value(browser, "#sheet-message", "hidden"))
    check("failed: and drawn again", ink(browser, "#drawing") > 1000)
    link = value(browser, "#full-link", "href")
    beside = f"file://{folder}/javascript%3A5%20%23%3F%25%3C"
    check("zipped: link stays beside the page", link.startswith(beside), link)
    check_quiet(browser, "zipped")


def check_lazy(browser):
    drawn = "document.querySelectorAll('canvas[data-drawn]').length"
    browser.run("document.querySelector('.thumbnail').scrollIntoView()")
    seen = browser.wait(drawn)
    check("lazy: some thumbnails are drawn, not all", 5 < seen < 100, seen)
    browser.run("document.querySelectorAll('.thumbnail')[300].scrollIntoView()")
    browser.wait("document.querySelectorAll('.thumbnail')[300].querySelector('canvas[data-drawn]')")
    browser.wait("document.querySelector('.thumbnail canvas').dataset.drawn === undefined")
    check("lazy: those left are cleared", browser.run(drawn) < 100)
    expect("lazy: their canvas has no size", value(browser, ".thumbnail canvas", "width"), 0)
    browser.run("window.scrollTo(0, 0)")


def check_looks(browser, folder):
    """Both colour schemes, and no sideways scrolling at any width."""
    papers = []
    for page, scheme in (("zipped", "light"), ("crossed", "light"), ("crossed", "dark")):
        browser.set_media(prefers_color_scheme=scheme)
        open_page(browser, folder, page)
        for width in (320, 390, 1000, 1600):
            browser.resize(width, 844)
            browser.run("""new Promise((done) =>
                requestAnimationFrame(() => requestAnimationFrame(done)))""")
            needed, there = browser.run("[document.documentElement.scrollWidth, innerWidth]")
            check(f"{page}: no sideways scrolling at {width} {scheme}", needed <= there, needed)
        papers.append(browser.run("""[
            getComputedStyle(document.getElementById('sheet')).backgroundColor,
            document.getElementById('drawing').getContext('2d').strokeStyle]"""))
    (light, ink_on_light), (dark, ink_on_dark) = papers[1:]
    check("looks: dark is another paper", light != dark, papers)
    check("looks: dark is another ink", ink_on_light != ink_on_dark, papers)
    browser.set_media(prefers_color_scheme="light")


def check_phone(folder):
    with Browser(phone=True) as phone:
        open_page(phone, folder, "crossed")
        expect("phone: no sideways scrolling",
               phone.run("[document.documentElement.scrollWidth, innerWidth]"), [390, 390])
        small = phone.run("""[...document.querySelectorAll('.play, select, .thumbnail, .switch')]
            .filter((control) => Math.min(control.offsetWidth, control.offsetHeight) < 40)
            .map((control) => control.className || control.id)""")
        expect("phone: controls for thumbs", small, [])
        expect("phone: as sharp as the screen", value(phone, "#drawing", "width"), 3 * 390)
        phone.drag("#sheet", 0.75, 0.5, "touch")
        expect("phone: a finger turns the view", number(phone, "azimuth_deg"), "90°")
        phone.run("window.scrollTo(0, 1500)")
        top = phone.run("document.getElementById('sheet').getBoundingClientRect().top")
        expect("phone: the drawing stays in sight", top, 0)
        check_quiet(phone, "phone")


def main():
    with tempfile.TemporaryDirectory(prefix="orograph-test-") as folder:
        subprocess.run([sys.argv[1], folder], check=True)
        check_source(folder)
        with Browser() as browser:
            browser.resize(1600, 1000)
            check_empty(browser, folder)
            check_one(browser, folder)
            check_crossed(browser, folder)
            check_zipped(browser, folder)
            check_looks(browser, folder)
        check_phone(folder)
    print(f"{len(failures)} checks failed" if failures else "all as it should be")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
