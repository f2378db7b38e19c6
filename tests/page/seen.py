# SPDX-License-Identifier: GPL-3.0-or-later
"""What a page shows, and what it should."""

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


def count(browser, selector):
    return browser.run("document.querySelectorAll(arguments[0]).length", selector)


def values(browser, selector, key):
    """A property of every element, or an entry of its data set."""
    return browser.run("""[...document.querySelectorAll(arguments[0])]
        .map((element) => element[arguments[1]] ?? element.dataset[arguments[1]])""", selector, key)


def value(browser, selector, key):
    return values(browser, selector, key)[0]


def texts(browser, selector):
    return values(browser, selector, "textContent")


def number(browser, column):
    return text(browser, f'dd[data-column="{column}"]')


def name(browser):
    return text(browser, "#view-name")


def ink(browser, selector):
    """How many pixels of a canvas have ink."""
    return browser.run("""((canvas) => canvas.getContext('2d')
        .getImageData(0, 0, canvas.width, canvas.height).data
        .filter((value, i) => i % 4 === 3 && value > 20).length)
        (document.querySelector(arguments[0]))""", selector)


def choose(browser, selector, wanted):
    """Moves a slider or makes a choice as a hand would, events and all."""
    browser.run("""((control) => {
        control.value = arguments[1];
        for (const kind of ['input', 'change'])
            control.dispatchEvent(new Event(kind, {bubbles: true}));
        })(document.querySelector(arguments[0]))""", selector, wanted)


def points(browser):
    return count(browser, "#plot circle.point")


def check_quiet(browser, page):
    """Nothing on the console, and nothing asked for but files beside the page."""
    expect(f"{page}: console", browser.log("browser"), [])
    local = ("file:///", "data:,", "about:")
    asked = [url for url in browser.requests() if not url.startswith(local)]
    expect(f"{page}: requests", asked, [])
