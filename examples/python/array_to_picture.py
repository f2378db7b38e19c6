# SPDX-License-Identifier: GPL-3.0-or-later
# An array of numpy becomes a picture, in five lines.
import numpy as np
import orograph

y, x = np.mgrid[-3:3:300j, -3:3:400j]
z = 900 * np.exp(-(x**2) - y**2) + 300 * np.sin(3 * x) * np.cos(2 * y)
terrain = orograph.terrain(z.astype(np.float32), transform=(0, 20, 0, 0, 0, -20))
drawing = terrain.render(view_from=(215, 30), contours="auto")
drawing.save("picture.svg", overwrite=True)
