#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests tools/check_patch.py: in every format a moved vertex passes, and nothing else does."""
import base64
import gzip
import importlib.util
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "check_patch.py"
spec = importlib.util.spec_from_file_location("check_patch", TOOL)
check_patch = importlib.util.module_from_spec(spec)
sys.modules["check_patch"] = check_patch
spec.loader.exec_module(check_patch)

X = 0.125  # a coordinate that is nowhere else in the samples
MOVED = 0.625


def packed(order, code, *numbers):
    return struct.pack(f"{order}{len(numbers)}{code}", *numbers)


class PatchTest(unittest.TestCase):
    """What the tests of all formats share."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def check(self, suffix, before, after):
        paths = self.folder / f"before{suffix}", self.folder / f"after{suffix}"
        paths[0].write_bytes(before)
        paths[1].write_bytes(after)
        return check_patch.check(*paths)

    def expect_moved(self, suffix, before, after, coordinates=1, vertices=1):
        """Expects so many coordinates of so many vertices to have moved, in a file and in gzip."""
        self.assertNotEqual(before, after)
        wanted = f": {coordinates} coordinates of {vertices} "
        self.assertIn(": 0 coordinates of 0 ", self.check(suffix, before, before))
        self.assertIn(wanted, self.check(suffix, before, after))
        self.assertIn(wanted, self.check(suffix + ".gz", gzip.compress(before),
                                         gzip.compress(after)))

    def expect_refused(self, suffix, before, after):
        self.assertNotEqual(before, after)
        with self.assertRaises(check_patch.Difference):
            self.check(suffix, before, after)

    def expect_refused_edits(self, suffix, before, edits):
        """Refuses each edit (old, new) of a file, and what may go wrong at the end of any file."""
        for old, new in edits:
            with self.subTest(suffix=suffix, old=old, new=new):
                self.assertIn(old, before)
                self.expect_refused(suffix, before, before.replace(old, new, 1))
        for after in (before[:-1], before + b"\n", before + b" ", b""):
            with self.subTest(suffix=suffix, end=after[-10:]):
                self.expect_refused(suffix, before, after)

    def expect_text(self, suffix, before, edits, number=b"0.125"):
        """Tests a text in which the number is one coordinate of one vertex."""
        self.assertEqual(before.count(number), 1)
        self.expect_moved(suffix, before, before.replace(number, b"0.625"))
        self.expect_moved(suffix, before, before.replace(number, b"-6.25e-1"))
        wrong = [(number, new) for new in (b"nan", b"inf", b"1e999", b"0,625", b"0x1p3", b"", b"a",
                                           b"0.625 0.5", b" 0.625", b"0.625\t", b"0.625 #")]
        self.expect_refused_edits(suffix, before, wrong + edits + [
            (b"\n", b"\r\n"), (b"\n", b"\n\n"), (b"\n", b" \n")])


class TextFormats(PatchTest):
    def test_obj(self):
        self.expect_text(".obj", b"\xef\xbb\xbf# v 1 2 3\nmtllib a.mtl\nv 0 0 0 1 0.5 0.25\n"
                         b" v\t1.5 0 0.125 # c\nv 0 \\\n1 2.5\nvt 0.75 0\nvn 0 0 1\no part\n"
                         b"f 1/1/1 2//1 3\n", [
                             (b"a.mtl", b"b.mtl"), (b"0 1 0.5", b"0 2 0.5"),
                             (b"# v 1", b"# v 2"), (b"1 0.5", b"1 0.6"),
                             (b"vt 0.75", b"vt 0.8"), (b"vn 0", b"vn 1"), (b"part", b"Part"),
                             (b"f 1/1/1 2", b"f 1/1/1 1"), (b"v\t", b"v "), (b"# c", b"# d")])
        continued = b"v 0 \\\n1 2.5\nv 0 0 0\n"
        self.expect_moved(".obj", continued, continued.replace(b"2.5", b"3"))

    def test_off(self):
        self.expect_text(".off", b"OFF # c\n\n3 1 0\n# 1\n0 0 0\n1.5 0 0.125\n 0 1 0\n"
                         b"3 0 1 2 255 0 0\n",
                         [(b"# c", b"# d"), (b"# 1", b"# 2"), (b"255", b"254"),
                          (b"3 0 1", b"3 1 0"), (b"3 1 0", b"3 1 1"), (b"\n 0", b"\n0")])
        for keyword, row in ((b"COFF", b" 255 0 7 255"), (b"NOFF", b" 0 7 1"),
                             (b"CNOFF", b" 0 7 1 0.1 0.2 0.3 1"), (b"STOFF", b" 0.7 7"),
                             (b"4OFF", b" 7"), (b"STCNOFF", b" 0 0 7 1 1 1 1 0.5 0.5")):
            with self.subTest(keyword=keyword):
                text = keyword + b" 2 0 0\n1 2 0.125" + row + b"\n0 0 0" + row + b"\n"
                self.expect_text(".off", text, [(b"7", b"8")])
        flat = b"NOFF\n2 0 0\n1 2 0.125 0 0 7 4\n5 6 0 0 1\n"
        self.expect_text(".off", flat, [(b"7", b"8"), (b" 1\n", b" 2\n")])

    def test_ply(self):
        self.expect_text(".ply", b"ply\nformat ascii 1.0\ncomment x\nelement face 1\n"
                         b"property list uchar int vertex_indices\nproperty uchar red\n"
                         b"element vertex 3\nproperty float z\nproperty float nx\n"
                         b"property uchar red\nproperty double x\nproperty float y\nend_header\n"
                         b"3 0 1 2 200\n0 0.75 9 0 0\n0.125 0.8 8 1 0\n0 1 7 0.5 1\n",
                         [(b"comment x", b"comment y"), (b"0.75", b"0.7"), (b" 8 ", b" 9 "),
                          (b"3 0 1", b"3 1 0"), (b"200", b"201"), (b"float z", b"double z")])

    def test_msh(self):
        self.expect_text(".msh", b'$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n'
                         b'2 7 "in"\n$EndPhysicalNames\n$Nodes\n3\n1 0 0 0\n2 1 0 0.125\n9 0 1 0\n'
                         b'$EndNodes\n$Elements\n1\n1 2 2 7 1 1 2 9\n$EndElements\n$NodeData\n1\n'
                         b'"T"\n0\n3\n0\n1\n1\n9 0.75\n$EndNodeData\n',
                         [(b'"in"', b'"In"'), (b"\n9 0 1", b"\n8 0 1"), (b"2 7 1", b"2 8 1"),
                          (b"1 2 9", b"1 9 2"), (b"0.75", b"0.8"), (b'"T"', b'"U"'),
                          (b"2.2", b"2.1")])
        self.expect_text(".msh", b"$NOD\n2\n1 0 0 0\n2 0.125 0 0\n$ENDNOD\n$ELM\n0\n$ENDELM\n",
                         [(b"\n2 0", b"\n3 0"), (b"$ELM\n0", b"$ELM\n1")])
        self.expect_text(".msh", b"$MeshFormat\n4 0 8\n$EndMeshFormat\n$Nodes\n2 3\n1 1 1 1\n"
                         b"1 0 0 0 0.75\n2 2 0 2\n2 0.125 0 0\n3 1 1 1\n$EndNodes\n$Elements\n"
                         b"0 0\n$EndElements\n", [(b"0.75", b"0.7"), (b"\n3 1", b"\n4 1")])
        self.expect_text(".msh", b"$Comments\n$Nodes\n$EndComments\n$MeshFormat\n4.1 0 8\n"
                         b"$EndMeshFormat\n$Nodes\n2 3 1 3\n2 1 1 1\n1\n0 0 0 0.75 0.3\n2 2 0 2\n"
                         b"2\n3\n0.125 0 0\n1 1 1\n$EndNodes\n", [
                             (b"0.75", b"0.7"), (b"0.3", b"0.4"), (b"2\n3\n", b"2\n4\n")])

    def test_vtk(self):
        for kind, extra in ((b"UNSTRUCTURED_GRID", b"CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n"),
                            (b"POLYDATA", b"POLYGONS 1 4\n3 0 1 2\n"),
                            (b"STRUCTURED_GRID", b"")):
            dimensions = b"" if extra else b"DIMENSIONS 3 1 1\n"
            text = (b"# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET " + kind + b"\n"
                    b"FIELD FieldData 1\nt 1 1 float\n0.75\n" + dimensions + b"POINTS 3 float\n"
                    b"0 0 0 1 0 0.125\n0 1 0\n" + extra + b"POINT_DATA 3\nSCALARS s float\n"
                    b"LOOKUP_TABLE default\n7 8 9\n")
            edits = [(b"0.75", b"0.7"), (b"title", b"Title"), (b"7 8", b"7 9"),
                     (b"SCALARS s", b"SCALARS t"), (b"float\n0 0", b"double\n0 0")]
            self.expect_text(".vtk", text, edits + ([(b"3 0 1", b"3 1 0")] if extra else []))

    def test_medit(self):
        self.expect_text(".mesh", b"# Vertices\nMeshVersionFormatted 2\nDimension\n3\nVertices # c"
                         b"\n3\n0 0 0 1\n1 0 0.125 7\n0 1 0 1\nTriangles 1\n1 2 3 5\n"
                         b"RequiredVertices\n1\n2\nEnd\n",
                         [(b"# c", b"# d"), (b" 7", b" 8"), (b"3 5", b"3 6"), (b"1\n2", b"1\n1")])
        self.expect_text(".mesh", b"MeshVersionFormatted 1\nDimension 2\nVertices 2\n0 0 3\n"
                         b"0.125 1 7\nEnd\n", [(b" 7", b" 8")])

    def test_su2(self):
        self.expect_text(".su2", b"% c\nNDIME= 2\nNELEM= 1\n5 0 1 2 0\nNPOIN= 3 3\n0 0 0\n% d\n"
                         b"  1 0.125  7\n0 1 2\nNMARK= 1\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n"
                         b"3 0 1\n", [(b"% c", b"% e"), (b"% d", b"% e"), (b"wall", b"Wall"),
                                      (b" 7", b" 8"), (b"5 0 1", b"5 1 0")])
        self.expect_text(".su2", b"NDIME= 3\nNPOIN= 2\n0 0 0.125 7\n1 1 1 1\n", [(b" 7", b" 8")])

    def test_abaqus(self):
        text = (b"*Heading\n** 1, 2, 3, 4\n*NODE PRINT\n1, 2, 3\n*Node, nset=a,\nsystem=r\n"
                b"** 5, 6\n1, 0., 0., 0.\n7,  1.5 ,0.,0.125\n3, 0., 2D0, 0., 4., 5., 6.\n"
                b"*ELEMENT, TYPE=S3, ELSET=b\n1, 1, 7, 3\n*NSET, NSET=c\n1, 7\n")
        self.expect_text(".inp", text, [
            (b"** 1", b"** 2"), (b"** 5", b"** 6"), (b"PRINT\n1, 2", b"PRINT\n1, 3"),
            (b"\n7,", b"\n8,"),
            (b"4., 5.", b"4., 6."), (b"1, 1, 7", b"1, 7, 1"), (b"ELSET=b", b"ELSET=c"),
            (b"1.5 ,", b"1.5,")])
        self.expect_moved(".inp", text, text.replace(b"2D0", b"-2.5d+00"))

    def test_ucd(self):
        self.expect_text(".inp", b"# c\n3 1 1 0 0\n1 0 0 0\n7\t1 0 0.125\n3 0 1 0\n1 4 tri 1 7 3\n"
                         b"1 1\ns, m\n1 0.75\n", [(b"# c", b"# d"), (b"\n7", b"\n8"),
                                                  (b"1 4 tri", b"1 5 tri"), (b"0.75", b"0.7")])


class NastranFormat(PatchTest):
    SMALL = (b"$ GRID\nSOL 101\nCEND\nBEGIN BULK\nGRID           1       0      0.     0.5    .125"
             b"     8.5\nGRID    2               1.43-13 2.+3    7.0\n"
             b"CROD           1       1       1       2\n$ c\nENDDATA\n")

    def test_small_fields(self):
        text = self.SMALL
        for old, new in ((b"    .125", b"    .625"), (b"    .125", b"-6.25-10"),
                         (b"1.43-13 ", b"1.44-13 "), (b"7.0\n", b"7.125678\n")):
            self.expect_moved(".bdf", text, text.replace(old, new))
        self.expect_refused_edits(".bdf", text, [
            (b".125", b".1250"), (b"   .125", b".6250"), (b"    .125", b"    .1.5"),
            (b"    .125", b"     625"), (b"    .125", b"     nan"), (b"25     8.5", b"25     9.5"),
            (b"2               1.43", b"2           1.0 1.43"),
            (b"7.0\n", b"7.1256789\n"), (b"GRID    2", b"GRID    3"), (b"$ c", b"$ d"),
            (b"$ GRID", b"$ grid"), (b"CROD           1", b"CROD           2"), (b"\n", b"\r\n")])

    def test_wide_fields(self):
        text = (b"BEGIN BULK\nGRID*                  1               0            0.25D0"
                b"            0.5  *A\n*A                  .125             7.5\n"
                b"GRID*,2,,1.,2.\n*,3.5,8\nENDDATA\n")
        for old, new in ((b"          .125", b"-1.23456789E-3"), (b"0.25D0", b"0.75D0"),
                         (b"1.,2.", b"1.25,2."), (b"*,3.5", b"*,3.75")):
            self.expect_moved(".nas", text, text.replace(old, new))
        self.expect_refused_edits(".nas", text, [
            (b".125", b".1250"), (b"*A   ", b"*B   "), (b"7.5\n", b"8.5\n"), (b"5  *A", b"5  *B"),
            (b"3.5,8", b"3.5,9"), (b"*,3.5", b"*, 3.5"), (b"*,2", b"*,3")])

    def test_free_fields(self):
        text = b"BEGIN BULK\ngrid,1,, 0.,.125 ,2.\nGRID,2,0,1.,1.,1.,4,5\nENDDATA\n"
        for old, new in ((b".125", b"-1.5"), (b",2.\n", b",2.125\n"), (b"1.,4", b"1.5-7,4")):
            self.expect_moved(".dat", text, text.replace(old, new))
        self.expect_refused_edits(".dat", text, [
            (b", 0.", b",0."), (b".125 ,", b".125,"), (b"1.,4", b"1.,5"), (b"d,1", b"d,3")])


def legal_and_illegal(before, old, new):
    """A binary sample with a number replaced, and every byte outside of the number spoilt."""
    at = before.index(old)
    assert before.count(old) == 1
    spoilt = [before[:i] + bytes([before[i] ^ 1]) + before[i + 1:]
              for i in range(len(before)) if not at <= i < at + len(old)]
    return before.replace(old, new), spoilt


class BinaryFormats(PatchTest):
    def expect_binary(self, suffix, before, order, code, coordinates_bytes):
        """Tests a binary file in which X is one coordinate. A flipped bit anywhere else is seen."""
        old, new = struct.pack(order + code, X), struct.pack(order + code, MOVED)
        after, spoilt = legal_and_illegal(before, old, new)
        self.expect_moved(suffix, before, after)
        passing = 0
        for changed in spoilt:
            try:
                self.check(suffix, before, changed)
                passing += 1
            except (check_patch.Difference, check_patch.Unreadable):
                pass
        self.assertLessEqual(passing, coordinates_bytes - len(old))
        for number in (float("nan"), float("inf")):
            bad = before.replace(old, struct.pack(order + code, number))
            self.expect_refused(suffix, before, bad)
        for bad in (before[:-1], before + b"\0", before[:len(before) // 2], b""):
            self.expect_refused(suffix, before, bad)

    def test_ply(self):
        for name, order in ((b"little", "<"), (b"big", ">")):
            head = (b"ply\nformat binary_" + name + b"_endian 1.0\nelement face 1\n"
                    b"property list uchar int vertex_indices\nelement vertex 3\n"
                    b"property uchar red\nproperty double y\nproperty float x\n"
                    b"property short s\nproperty float z\nend_header\n")
            body = b"\3" + packed(order, "i", 0, 1, 2)
            for x in (0.5, X, 2.5):
                body += struct.pack(order + "Bdfhf", 7, 3.0, x, 4, 1.5)
            self.expect_binary(".ply", head + body, order, "f", 3 * 16)

    def test_msh2(self):
        head = b"$MeshFormat\n2.2 1 8\n\1\0\0\0\n$EndMeshFormat\n$Nodes\n2\n"
        nodes = b"".join(struct.pack("<iddd", i, x, 1, 2) for i, x in ((1, X), (5, 0.75)))
        tail = b"\n$EndNodes\n$Elements\n1\n" + packed("<", "i", 1, 1, 2, 1, 7, 7, 1, 5)
        self.expect_binary(".msh", head + nodes + tail + b"\n$EndElements\n", "<", "d", 6 * 8)
        head = head.replace(b"$Nodes\n2", b"$ParametricNodes\n3")
        nodes = struct.pack("<i3dii2d", 1, 1, 2, 3, 2, 7, 4, 5) + struct.pack(
            "<i3dii", 2, 1, 2, 3, 0, 7) + struct.pack("<i3diid", 3, X, 2, 3, 1, 7, 4)
        self.expect_binary(".msh", head + nodes + b"\n$EndParametricNodes\n", "<", "d", 9 * 8)

    def test_msh4(self):
        head = b"$MeshFormat\n%s 1 8\n\1\0\0\0\n$EndMeshFormat\n$Nodes\n"
        nodes = packed("<", "Q", 1, 2) + struct.pack("<iiiQ", 4, 2, 1, 2)
        nodes += struct.pack("<i5d", 1, X, 1, 2, 3, 4) + struct.pack("<i5d", 5, 6, 7, 8, 9, 10)
        self.expect_binary(".msh", head % b"4" + nodes + b"\n$EndNodes\n", "<", "d", 6 * 8)
        nodes = packed("<", "Q", 1, 2, 1, 5) + struct.pack("<iiiQ", 2, 4, 1, 2)
        nodes += packed("<", "Q", 1, 5) + packed("<", "d", X, 1, 2, 3, 4, 6, 7, 8, 9, 10)
        self.expect_binary(".msh", head % b"4.1" + nodes + b"\n$EndNodes\n", "<", "d", 6 * 8)

    def test_vtk(self):
        for kind in (b"UNSTRUCTURED_GRID", b"POLYDATA", b"STRUCTURED_GRID\nDIMENSIONS 2 1 1"):
            for code, name in (("f", b"float"), ("d", b"double")):
                data = (b"# vtk DataFile Version 3.0\nt\nBINARY\nDATASET " + kind + b"\nPOINTS 2 "
                        + name + b"\n" + packed(">", code, 0, 0, 0, X, 1, 2) + b"\nPOINT_DATA 2\n"
                        b"SCALARS s int\nLOOKUP_TABLE default\n" + packed(">", "i", 7, 8) + b"\n")
                self.expect_binary(".vtk", data, ">", code, 6 * struct.calcsize(code))

    def test_meshb(self):
        for order in "<>":
            for version in (1, 2, 3, 4):
                with self.subTest(version=version, order=order):
                    self.expect_binary(".meshb", self.meshb(order, version), order,
                                       "f" if version == 1 else "d",
                                       6 * (4 if version == 1 else 8))

    @staticmethod
    def meshb(order, version):
        position, integer = "q" if version >= 3 else "i", "q" if version == 4 else "i"
        real = "f" if version == 1 else "d"
        data = struct.pack(order + "ii", 1, version)

        def section(keyword, body):
            end = len(data) + 4 + struct.calcsize(position) + len(body)
            return struct.pack(order + "i" + position, keyword, end) + body
        data += section(3, struct.pack(order + "i", 3))
        data += section(4, struct.pack(order + integer, 2) + b"".join(
            struct.pack(order + "3" + real + integer, *place, 7) for place in
            ((X, 1, 2), (3, 4, 5))))
        data += section(6, struct.pack(f"{order}5{integer}", 1, 1, 2, 2, 9))
        return data + struct.pack(order + "i" + position, 54, 0)


class StlFormats(PatchTest):
    FACETS = [((0, 0, 1), (0, 0, 0), (1, 0, 0), (0, 1, 0)),
              ((0, 0, 1), (1, 0, 0), (1, 1, 0), (0, 1, 0)),
              ((1, 0, 0), (5, 0, 0), (5, 1, 0), (5, 0, 1))]

    @staticmethod
    def moved(facets):
        """Moves the corner of the first two facets, which changes their normals too."""
        return [tuple((1.5, 0.25, 0) if row == (1, 0, 0) and place else row
                      for place, row in enumerate(facet)) for facet in facets]

    @staticmethod
    def with_normal(facets, number):
        return [((0, 1, 0), *facet[1:]) if i == number else facet for i, facet in enumerate(facets)]

    @staticmethod
    def binary(facets, attribute=0):
        return b"\0solid".ljust(80, b"x") + struct.pack("<I", len(facets)) + b"".join(
            packed("<", "f", *(x for row in facet for x in row)) + struct.pack("<H", attribute)
            for facet in facets)

    @staticmethod
    def ascii(facets):
        lines = ["solid vertex 1 2 3"]
        for normal, *corners in facets:
            lines += ["facet normal %g %g %g" % normal, "  outer loop"]
            lines += ["    vertex %g %g %g" % corner for corner in corners]
            lines += ["  endloop", "endfacet"]
        return "\n".join(lines + ["endsolid vertex", ""]).encode()

    def test_corners_and_their_normals_may_move(self):
        for form in (self.binary, self.ascii):
            before, moved = form(self.FACETS), self.moved(self.FACETS)
            self.expect_moved(".stl", before, form(moved), 4, 2)
            self.expect_moved(".stl", before, form(self.with_normal(moved, 0)), 4, 2)

    def test_nothing_else_may_change(self):
        for form in (self.binary, self.ascii):
            before, moved = form(self.FACETS), self.moved(self.FACETS)
            torn = [moved[0], *self.FACETS[1:]]
            for facets in (self.with_normal(self.FACETS, 0), self.with_normal(moved, 2), torn,
                           moved[:2], moved + moved[:1]):
                self.expect_refused(".stl", before, form(facets))
        before = self.binary(self.FACETS)
        self.expect_refused(".stl", before, self.binary(self.FACETS, 1))
        self.expect_refused(".stl", before, before[:79] + b"y" + before[80:])
        self.expect_refused(".stl", before, before + b"\0")
        self.expect_refused_edits(".stl", self.ascii(self.FACETS), [
            (b"vertex 1", b"vertex 2"), (b"  outer", b" outer"), (b"endsolid v", b"endsolid V"),
            (b"\n", b"\r\n"), (b"vertex 5 0 0", b"vertex 5 0 nan")])


class VtkXmlFormats(PatchTest):
    POINTS = (0, 0, 0, 1, 0, X, 0, 1, 0)
    MOVED_POINTS = (0, 0, 0, 1, 0, MOVED, 0, 1, 0.1)

    @staticmethod
    def encode(data, order, size, compressor, is_base64):
        """An array as VTK writes it, in two blocks where it is compressed."""
        text = base64.b64encode if is_base64 else bytes
        if not compressor:
            return text(struct.pack(order + size, len(data)) + data)
        block = 20
        blocks = [zlib.compress(data[i:i + block]) for i in range(0, len(data), block)]
        header = [len(blocks), block, len(data) % block, *map(len, blocks)]
        return text(packed(order, size, *header)) + text(b"".join(blocks))

    def file(self, points, mode, order="<", size="I", compressor=False, field=7.0, extra=b"",
             kind=b"UnstructuredGrid"):
        """A file of three points with two arrays in front of the points and behind them."""
        inline = mode in ("ascii", "binary")
        arrays = [(b"s", (field, 8.0, 9.0)), (b"Points", points), (b"t", (4.0, 5.0, 6.0))]
        appended = b"_"
        texts = []
        for name, numbers in arrays:
            coded = self.encode(packed(order, "f", *numbers), order, size, compressor,
                                mode in ("binary", "base64"))
            opening = b'<DataArray type="Float32" Name="%s" NumberOfComponents="3" ' % name
            if inline:
                content = b" ".join(b"%g" % n for n in numbers) if mode == "ascii" else coded
                form = b"ascii" if mode == "ascii" else b"binary"
                texts.append(opening + b'format="%s">\n  %s\n</DataArray>' % (form, content))
            else:
                texts.append(opening + b'format="appended" offset="%d"/>' % (len(appended) - 1))
                appended += coded
        tail = b"" if inline else (b'<AppendedData encoding="%s">\n   ' % mode.encode() + appended
                                   + b"\n</AppendedData>\n")
        head = b'<VTKFile type="%s" byte_order="%s" header_type="%s"%s>' % (
            kind, b"LittleEndian" if order == "<" else b"BigEndian",
            b"UInt64" if size == "Q" else b"UInt32",
            b' compressor="vtkZLibDataCompressor"' if compressor else b"")
        return (b'<?xml version="1.0"?>\n<!-- c' + extra + b' -->\n' + head + b"<" + kind
                + b'><Piece NumberOfPoints="3"><PointData>' + texts[0] + b"</PointData><Points>"
                + texts[1] + b"</Points><CellData>" + texts[2] + b"</CellData></Piece></" + kind
                + b">\n" + tail + b"</VTKFile>\n")

    def test_points_may_move_and_nothing_else(self):
        for mode in ("ascii", "binary", "raw", "base64"):
            for order, size, compressor in (("<", "I", False), (">", "Q", False), ("<", "Q", True),
                                            (">", "I", True)):
                with self.subTest(mode=mode, order=order, size=size, compressor=compressor):
                    self.expect_points(mode=mode, order=order, size=size, compressor=compressor)

    def expect_points(self, **how):
        before = self.file(self.POINTS, **how)
        self.expect_moved(".vtu", before, self.file(self.MOVED_POINTS, **how), 2, 2)
        not_a_number = (float("nan"), *self.POINTS[1:])
        for after in (self.file(self.MOVED_POINTS, field=7.5, **how),
                      self.file(self.MOVED_POINTS, extra=b" ", **how),
                      self.file(self.MOVED_POINTS + (1, 2, 3), **how),
                      self.file(self.MOVED_POINTS[:6], **how),
                      self.file(not_a_number, **how), before[:-1], before + b"\n",
                      before.replace(b'Name="t"', b'Name="u"'),
                      before.replace(b"</Piece>", b" </Piece>"),
                      re.sub(rb"\s*((?:</DataArray>)?</Points>)", rb"  \1", before),
                      before.replace(b'"s" ', b'"s"  ')):
            self.expect_refused(".vtu", before, after)

    def test_polydata(self):
        before = self.file(self.POINTS, "ascii", kind=b"PolyData")
        after = self.file(self.MOVED_POINTS, "ascii", kind=b"PolyData")
        self.expect_moved(".vtp", before, after, 2, 2)

    def test_spaces_behind_an_offset_may_fill_up_for_its_digits(self):
        before = self.file(self.POINTS, "raw", compressor=True)
        after = self.file(self.MOVED_POINTS, "raw", compressor=True)
        after = after.replace(b'"/></CellData>', b'"  /></CellData>')
        self.expect_moved(".vtu", before, after, 2, 2)

    def test_an_offset_has_to_lead_to_its_array(self):
        for compressor in (False, True):
            before = self.file(self.POINTS, "raw", compressor=compressor)
            self.expect_refused(".vtu", before, before.replace(b'offset="0"', b'offset="1"'))


class CommandLine(PatchTest):
    def run_tool(self, before, after):
        paths = self.folder / "before.obj", self.folder / "after.obj"
        paths[0].write_bytes(before)
        paths[1].write_bytes(after)
        done = subprocess.run([sys.executable, TOOL, *paths], capture_output=True, text=True)
        return done.returncode, done.stdout

    def test_exit_status_and_output(self):
        self.assertEqual(self.run_tool(b"v 0 0 0\nv 1 1 1\n", b"v 0 2 0\nv 1 3 4\n"),
                         (0, "obj: 3 coordinates of 2 vertices changed, nothing else\n"))
        status, output = self.run_tool(b"v 0 0 0\n# a\n", b"v 0 0 1\n# b\n")
        self.assertEqual(status, 1)
        self.assertIn("line 2 (byte 10)", output)

    def test_a_file_stays_in_gzip(self):
        path = self.folder / "before.obj"
        path.write_bytes(gzip.compress(b"v 0 0 0\n"))
        after = self.folder / "after.obj"
        after.write_bytes(b"v 0 0 1\n")
        with self.assertRaises(check_patch.Difference):
            check_patch.check(path, after)

    def test_a_file_in_no_known_format_is_neither_right_nor_wrong(self):
        path = self.folder / "before.xyz"
        path.write_bytes(b"nothing\n")
        done = subprocess.run([sys.executable, TOOL, path, path], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)


if __name__ == "__main__":
    unittest.main()
