# SPDX-License-Identifier: GPL-3.0-or-later
"""Headless Chromium through the WebDriver protocol, with nothing but the standard library."""

import base64
import json
import shutil
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

KEYS = {"left": "\ue012", "up": "\ue013", "right": "\ue014", "down": "\ue015", "tab": "\ue004",
        "space": " "}
# chromedriver is on this machine, whatever proxy the surroundings name.
DIRECTLY = urllib.request.build_opener(urllib.request.ProxyHandler({}))
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"


class Browser:
    """One chromedriver and one Chromium; leave the `with` block and both are gone."""

    def __init__(self, phone=False):
        for program in ("chromium", "chromedriver"):
            if shutil.which(program) is None:
                raise SystemExit(f"page_test: error: {program} isn't there: "
                                 "run scripts/install-dependencies test")
        self.profile = tempfile.mkdtemp(prefix="orograph-test-")
        self.driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE,
                                       stderr=subprocess.DEVNULL, text=True)
        try:
            self.base = f"http://127.0.0.1:{self._read_port()}/session"
            self._start_session(phone)
        except BaseException:
            self._end()
            raise

    def _read_port(self):
        for line in self.driver.stdout:
            if "started successfully on port" in line:
                return int(line.split()[-1].rstrip("."))
        raise RuntimeError("chromedriver didn't start")

    def _start_session(self, phone):
        options = {"args": ["--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                            "--disable-dev-shm-usage", f"--user-data-dir={self.profile}"]}
        if phone:
            metrics = {"width": 390, "height": 844, "pixelRatio": 3, "touch": True, "mobile": True}
            options["mobileEmulation"] = {"deviceMetrics": metrics}
        wanted = {"browserName": "chrome", "goog:chromeOptions": options,
                  "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"}}
        answer = self._ask("POST", "", {"capabilities": {"alwaysMatch": wanted}})
        self.base += "/" + answer["sessionId"]

    def _ask(self, method, path, body=None):
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self.base + path, data=data, method=method,
                                         headers={"Content-Type": "application/json"})
        try:
            with DIRECTLY.open(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(f"{path}: {json.load(error)['value']['message']}") from None

    def _end(self):
        self.driver.terminate()
        self.driver.wait(20)
        self.driver.stdout.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self._ask("DELETE", "")
        finally:
            self._end()

    def open(self, address):
        """A new page even where only the hash differs."""
        self._ask("POST", "/url", {"url": "about:blank"})
        self.log("browser"), self.log("performance")
        self._ask("POST", "/url", {"url": address})

    def run(self, script, *arguments):
        """The value of a JavaScript expression; arguments are `arguments[0]` and so on."""
        return self._ask("POST", "/execute/sync",
                         {"script": "return " + script, "args": list(arguments)})

    def wait(self, script, *arguments, seconds=20):
        """Until an expression is true; its value."""
        end = time.monotonic() + seconds
        while True:
            value = self.run(script, *arguments)
            if value:
                return value
            if time.monotonic() > end:
                raise AssertionError(f"never true: {script} {arguments}")
            time.sleep(0.02)

    def click(self, selector):
        found = self._ask("POST", "/element", {"using": "css selector", "value": selector})
        self._ask("POST", f"/element/{found[ELEMENT]}/click", {})

    def press(self, *names):
        strokes = [{"type": kind, "value": KEYS[name]}
                   for name in names for kind in ("keyDown", "keyUp")]
        self._act({"type": "key", "id": "keys", "actions": strokes})

    def drag(self, selector, begin, end, kind="mouse"):
        """With the pointer, between two shares of an element's width, at half of its height."""
        x, y, width, height = self.run(
            "(({x, y, width, height}) => [x, y, width, height])"
            "(document.querySelector(arguments[0]).getBoundingClientRect())", selector)
        def move(share):
            return self.move_to(x + share * width, y + height / 2)
        self.point([move(begin), self.DOWN, move((begin + end) / 2), move(end), self.UP], kind)

    DOWN = {"type": "pointerDown", "button": 0}
    UP = {"type": "pointerUp", "button": 0}

    @staticmethod
    def move_to(x, y):
        return {"type": "pointerMove", "duration": 20, "x": round(x), "y": round(y)}

    def point(self, steps, kind="mouse"):
        self._act({"type": "pointer", "id": kind, "parameters": {"pointerType": kind},
                   "actions": steps})

    def _act(self, source):
        self._ask("POST", "/actions", {"actions": [source]})

    def developer(self, command, **parameters):
        return self._ask("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def log(self, kind):
        return self._ask("POST", "/se/log", {"type": kind})

    def requests(self):
        """The address of everything asked for since the page was opened."""
        events = (json.loads(entry["message"])["message"] for entry in self.log("performance"))
        return [event["params"]["request"]["url"] for event in events
                if event["method"] == "Network.requestWillBeSent"]

    def resize(self, width, height):
        self.developer("Emulation.setDeviceMetricsOverride", width=width, height=height,
                       deviceScaleFactor=1, mobile=False)

    def set_media(self, **features):
        self.developer("Emulation.setEmulatedMedia", features=[
            {"name": name.replace("_", "-"), "value": value} for name, value in features.items()])

    def screenshot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self._ask("GET", "/screenshot")))
