#!/usr/bin/env python3
"""Writes numpy/: the same small tables as NumPy saves them in its formats. The tests do not run it."""
import os
import warnings

import numpy as np

table = np.array([[0, 0.1, 1 / 3, -2], [0.5, 5e-324, 1e300, 0], [-3, 1, 2, 3]])
small = np.array([[0, 0.1, 1 / 3, -2], [0.5, 6e-8, 65504, 0], [-3, 1, 2, 3]])
warnings.simplefilter("ignore")  # versions 2 and 3 of the format are said to be unreadable by old NumPy
os.makedirs(os.path.join(os.path.dirname(os.path.abspath(__file__)), "numpy"), exist_ok=True)
os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "numpy"))

np.save("c.npy", table)
np.save("fortran.npy", np.asfortranarray(table))
np.save("big-endian.npy", table.astype(">f8"))
np.save("single.npy", small.astype("<f4"))
np.save("half.npy", small.astype(">f2"))
np.save("integer.npy", np.array([[0, -1, -128, 7], [1, -1, 0, 127]], dtype="i1"))
np.save("unsigned.npy", np.array([[0, 2**64 - 1, 2**63, 7]], dtype=">u8"))
for version in (2, 3):
    with open(f"version-{version}.npy", "wb") as file:
        np.lib.format.write_array(file, table, version=(version, 0))

fields = np.dtype([("note", "U2"), ("f2", "<f8", (3,)), ("t", ">f4"), ("ok", "?")], align=True)
structured = np.zeros(3, dtype=fields)
structured["f2"], structured["t"], structured["note"] = table[:, 1:], table[:, 0], "ab"
np.save("structured.npy", structured)
quaternions = np.zeros(1, dtype=[("t", "<i4"), ("q", "<f8", (4,))])
quaternions[0] = (7, (2, 0, 0, 2))
np.save("quaternions.npy", quaternions)

np.save("one-dimension.npy", table[0])
np.save("three-dimensions.npy", table.reshape(3, 2, 2))
np.save("complex.npy", table.astype(complex))
np.save("objects.npy", table.astype(object), allow_pickle=True)
np.save("nan.npy", np.array([[0, 1, np.nan, 0]]))
np.save("empty.npy", table[:0])
np.savez("archive.npz", table)

np.savetxt("savetxt.txt", table)
np.savetxt("savetxt-header.txt", table, header="by NumPy\nt f2x f2y f2z")
np.savetxt("savetxt-semicolons.csv", table, delimiter=";", header="t;f2x;f2y;f2z", newline="\r\n")
np.savetxt("savetxt-commas.csv", table, delimiter=",", header="t f2x f2y f2z", comments="# ")
np.savetxt("savetxt-tabs.tsv", table, delimiter="\t", header="\ufefft\tf2x\tf2y\tf2z", comments="",
           encoding="utf8")
