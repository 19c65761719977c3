"""Opens the geometry of a run as ParaView does. Arguments: talus, a deck. Exit status 77 (skipped): no python3-vtk9."""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    print("skipped: python3-vtk9 is not installed")
    sys.exit(77)

with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], "run", sys.argv[2], "--out", folder, "--end", "10 ms"], check=True, stdout=subprocess.DEVNULL)
    sets = xml.etree.ElementTree.parse(os.path.join(folder, "sample2.pvd")).findall(".//DataSet")
    assert [round(float(s.get("timestep")), 5) for s in sets] == [0.0, 0.00496, 0.00993, 0.01001], sets
    for s in sets:
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(os.path.join(folder, s.get("file")))
        reader.Update()
        data = reader.GetOutput()
        # Ground, rock, 14 columns; 14 top and 12 bottom segments.
        assert data.GetNumberOfLines() == 16 + 26, data.GetNumberOfLines()
        cells = data.GetCellData()
        for name in ("body", "cable", "tension", "slack"):
            assert cells.GetArray(name).GetNumberOfTuples() == 42, name
        assert data.GetPointData().GetArray("body").GetNumberOfTuples() == data.GetNumberOfPoints()
        assert cells.GetArray("tension").GetRange()[1] > 22000.0  # the static shape's horizontal tension
        assert data.GetBounds()[5] == 27.5, data.GetBounds()  # half the span
print("read", len(sets), "files")
