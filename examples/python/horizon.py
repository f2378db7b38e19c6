# SPDX-License-Identifier: GPL-3.0-or-later
# The horizon of a place: as a polar plot, north up and the sky in the middle, and as a table.
# usage: horizon.py DEM LON LAT PICTURE TABLE.csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import orograph

dem, lon, lat, picture, table = sys.argv[1:]
terrain = orograph.read(dem)
horizon = terrain.horizon(eye_lonlat=(float(lon), float(lat)), horizon_step=0.5)

columns = [horizon.azimuth_deg, horizon.altitude_deg, horizon.distance_m]
np.savetxt(table, np.column_stack(columns), delimiter=",", fmt=["%g", "%.3f", "%.0f"],
           header="azimuth_deg,altitude_deg,distance_m", comments="")

ax = plt.figure(figsize=(7, 7)).add_subplot(projection="polar")
ax.set_theta_zero_location("N")
ax.set_theta_direction(-1)  # clockwise, as a compass
ax.set_rlim(90, min(0, np.nanmin(horizon.altitude_deg)))  # altitudes, the zenith in the middle
around = np.radians(np.append(horizon.azimuth_deg, 360))
skyline = np.append(horizon.altitude_deg, horizon.altitude_deg[0])
ax.fill_between(around, skyline, ax.get_rmin(), color="0.8")
ax.plot(around, skyline, color="black")
ax.figure.savefig(picture, dpi=150)

far = horizon.most_distant
print(f"highest: {np.nanmax(skyline):.1f} degrees; the most distant ground is "
      f"{far['distance_m'] / 1000:.1f} km away in azimuth {far['azimuth_deg']:.0f}")
