#!/usr/bin/env python3
"""Reads a VTKHDF file by VTK, and compares each of its states with the files for ParaView. Usage: read_states.py
INDEX.pvd FILE.vtkhdf. Exit status 1 if a number, a type or a name differs."""
import os
import sys
import xml.etree.ElementTree as ElementTree

import vtk
from vtk.util.numpy_support import vtk_to_numpy


def main(index, file):
    differing = 0

    def demand(same, what):
        nonlocal differing
        if not same:
            differing += 1
            print(f"{file}: {what}", file=sys.stderr)

    def compare(expected, found, what):
        a, b = vtk_to_numpy(expected), vtk_to_numpy(found)
        demand(a.shape == b.shape and a.dtype == b.dtype and (a == b).all(), what)

    sets = [(float(each.get("timestep")), os.path.join(os.path.dirname(index), each.get("file")))
            for each in ElementTree.parse(index).getroot().iter("DataSet")]
    reader = vtk.vtkHDFReader()
    reader.SetFileName(file)
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    demand(tuple(time for time, _ in sets) == tuple(times or ()), "times")
    for time, path in sets:
        xml = vtk.vtkXMLPolyDataReader()
        xml.SetFileName(path)
        xml.Update()
        reader.UpdateTimeStep(time)
        reader.Update()
        state, read = xml.GetOutput(), reader.GetOutputDataObject(0)
        where = f"t = {time}: "
        compare(state.GetPoints().GetData(), read.GetPoints().GetData(), where + "points")
        for kind in ("Verts", "Lines", "Polys", "Strips"):
            cells, others = getattr(state, f"Get{kind}")(), getattr(read, f"Get{kind}")()
            demand(cells.GetNumberOfCells() == others.GetNumberOfCells(), f"{where}number of {kind}")
            if cells.GetNumberOfCells() > 0:
                compare(cells.GetConnectivityArray(), others.GetConnectivityArray(), where + kind)
                compare(cells.GetOffsetsArray(), others.GetOffsetsArray(), f"{where}offsets of {kind}")
        for section in ("PointData", "CellData"):
            data, others = getattr(state, f"Get{section}")(), getattr(read, f"Get{section}")()
            names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
            demand(sorted(names) == sorted(others.GetArrayName(i) for i in range(others.GetNumberOfArrays())),
                   f"{where}names of {section}")
            for name in names:
                if others.HasArray(name):
                    compare(data.GetArray(name), others.GetArray(name), f"{where}{section} {name}")
    print(f"{file}: {len(sets)} states read by VTK {vtk.vtkVersion.GetVTKVersion()}, {differing} differences")
    return 0 if sets and differing == 0 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
