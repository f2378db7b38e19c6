# SPDX-License-Identifier: GPL-3.0-or-later
# R: persp, every cell a white facet with a black border, painted from the back.
#   Rscript persp.R DEM.heights OUTPUT.ps|.svg ELEVATION_DEG
arguments <- commandArgs(trailingOnly = TRUE)
file <- file(arguments[1], "rb")
header <- as.numeric(strsplit(trimws(readChar(file, 128)), " +")[[1]])
columns <- header[1]
rows <- header[2]
z <- matrix(readBin(file, "numeric", columns * rows, size = 4), columns, rows)
x <- (seq_len(columns) - 1) * header[3]
y <- (seq_len(rows) - 1) * header[4]
if (endsWith(arguments[2], ".svg")) {
  svg(arguments[2], width = 11.7, height = 8.3)
} else {
  postscript(arguments[2], width = 11.7, height = 8.3, paper = "special", horizontal = FALSE)
}
par(mar = c(0, 0, 0, 0), lwd = 0.2)
# From very far away, so that it is all but parallel; scale = FALSE keeps the axes' scales alike.
invisible(persp(x, y, z, theta = 0, phi = as.numeric(arguments[3]), r = 1e4, d = 1e4, scale = FALSE,
                box = FALSE, col = "white", border = "black"))
invisible(dev.off())
