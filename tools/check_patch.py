#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that a mesh file differs from another in coordinates of vertices only.

usage: check_patch.py BEFORE AFTER

It knows each format only as far as needed to say where coordinates stand, and shares no code with
the readers and writers it checks. All that stands between two coordinates has to be the same
bytes: white space, comments, ids, groups, fields. A coordinate that differs has to be a finite
number in both files. The normals of an STL may follow their corners, and corners at one place have
to stay together. Compressed VTK XML may move its later arrays: those offsets are not compared,
where they lead to is. Files in gzip are compared as what they contain.

Exit status 0 and a summary if only coordinates differ, 1 and the first other difference if not,
2 if BEFORE is in no format known here.
"""
import argparse
import base64
import binascii
import dataclasses
import gzip
import itertools
import lzma
import math
import os
import pathlib
import re
import struct
import sys
import typing
import zlib


class Unreadable(Exception):
    """Why it cannot be said where the coordinates of a file are."""


class Difference(Exception):
    """What else than a coordinate differs, and where."""


# Forms of a coordinate: where one that starts at a place ends, and which number it is.

WORD = re.compile(rb"[^\s,#%<\\]*")
LINE_END = re.compile(rb"[\r\n]|\Z")
DECIMAL = rb"[+-]?(?:\d+\.?\d*|\.\d+)"


def finite(number):
    return number if math.isfinite(number) else None


@dataclasses.dataclass(frozen=True)
class Word:
    """A number in a text that ends where the word ends."""
    number: re.Pattern

    def end(self, data, start):
        return WORD.match(data, start).end()

    def value(self, text):
        """The number if it is finite, else None."""
        match = self.number.fullmatch(text)
        return finite(float(match[1] + b"e" + (match[2] or b"0"))) if match else None


@dataclasses.dataclass(frozen=True)
class Columns:
    """A number in columns of fixed width. The end of a line may cut the last one short."""
    width: int

    def end(self, data, start):
        return LINE_END.search(data, start, min(start + self.width, len(data))).start()

    def value(self, text):
        """The number if it is finite, else None. Blank columns mean 0."""
        return NASTRAN_WORD.value(text.strip(b" ")) if text.strip(b" ") else 0.0


@dataclasses.dataclass(frozen=True)
class Binary:
    """A number as a program keeps it, by its code in struct."""
    code: str

    def end(self, data, start):
        return min(start + struct.calcsize(self.code), len(data))

    def value(self, data):
        """The number if it is finite, else None."""
        whole = len(data) == struct.calcsize(self.code)
        return finite(struct.unpack(self.code, data)[0]) if whole else None


PLAIN_WORD = Word(re.compile(rb"(" + DECIMAL + rb")(?:[eE]([+-]?\d+))?"))
FORTRAN_WORD = Word(re.compile(rb"(" + DECIMAL + rb")(?:[eEdD]([+-]?\d+))?"))


class NastranWord(Word):
    """A Nastran real: it has a point, and its exponent may come without a letter."""

    def value(self, text):
        match = self.number.fullmatch(text)
        if not match or b"." not in match[1]:
            return None
        return finite(float(match[1] + b"e" + (match[2] or match[3] or b"0")))


NASTRAN_WORD = NastranWord(
    re.compile(rb"(" + DECIMAL + rb")(?:[eEdD]([+-]?\d+)|([+-]\d+))?"))


class Coordinate(typing.NamedTuple):
    """One coordinate: where it is, in which form, and of which vertex, ~f for a facet's normal."""
    start: int
    end: int
    form: object
    vertex: int


@dataclasses.dataclass
class Layout:
    """A file as it is compared: where its coordinates are, and that all else has to be equal."""
    data: bytes
    coordinates: list = dataclasses.field(default_factory=list)
    noun: str = "vertices"
    corners: list = dataclasses.field(default_factory=list)  # of each facet, STL only
    origins: list = dataclasses.field(default_factory=list)  # (place here, place in the file)

    def add(self, start, end, form, vertex):
        self.coordinates.append(Coordinate(start, end, form, vertex))

    def add_words(self, words, vertex, form=PLAIN_WORD):
        """Adds coordinates that are words of the text."""
        for word in words:
            self.add(*word.span(), form, vertex)

    def add_row(self, start, form, vertex, count=3):
        """Adds binary coordinates that follow one another."""
        size = struct.calcsize(form.code)
        for at in range(start, start + count * size, size):
            self.add(at, at + size, form, vertex)

    def vertex_count(self):
        return len({c.vertex for c in self.coordinates if c.vertex >= 0})

    def place(self, at):
        """Where that is in the file, for people."""
        offset = at
        for here, there in self.origins:
            if here <= at:
                offset = there + at - here
        if b"\0" in self.data:
            return f"byte {offset:,}"
        line = len(re.findall(rb"\r\n|\r|\n", self.data[:at])) + 1
        return f"line {line:,} (byte {offset:,})"


# What the parsers share.

LINE = re.compile(rb"[^\r\n]+")


def words_of(data, start=0, comment=None, end=None):
    """The words of a text one after another, without comments that go to the end of a line."""
    end = len(data) if end is None else end
    if comment is None:
        return re.compile(rb"\S+").finditer(data, start, end)
    pattern = re.compile(comment + rb"[^\r\n]*|[^\s" + comment + rb"]+")
    return (w for w in pattern.finditer(data, start, end) if not w[0].startswith(comment))


def take(words, count):
    """The next words, so many."""
    taken = list(itertools.islice(words, count)) if count >= 0 else None
    if taken is None or len(taken) < count:
        raise Unreadable("the file ends early, or a count is wrong")
    return taken


def take_integers(words, count):
    try:
        return [int(word[0]) for word in take(words, count)]
    except ValueError as error:
        raise Unreadable(str(error)) from error


def skip_to(words, wanted):
    """Goes on to just after a word, whatever its case."""
    for word in words:
        if word[0].lower() == wanted:
            return
    raise Unreadable(f"there is no {wanted.decode()}")


def unpack(code, data, at):
    """The numbers at a place of a binary file, and the place after them."""
    end = at + struct.calcsize(code)
    if at < 0 or end > len(data):
        raise Unreadable("the file ends early, or a count is wrong")
    return struct.unpack(code, data[at:end]), end


def expect_room(data, at, size):
    """Refuses a count that goes past the end of the file."""
    if size < 0 or at + size > len(data):
        raise Unreadable("the file ends early, or a count is wrong")


# OBJ

OBJ_LINE = re.compile(rb"(?:\\(?:\r\n|\r|\n)|[^\r\n])+")
OBJ_WORD = re.compile(rb"[^\s#\\]+")


def parse_obj(data):
    layout = Layout(data)
    vertex = 0
    for line in OBJ_LINE.finditer(data, 3 if data.startswith(b"\xef\xbb\xbf") else 0):
        words = OBJ_WORD.finditer(data, *line.span())
        first = next(words, None)
        if first and first[0] == b"v" and b"#" not in data[line.start():first.start()]:
            comment = data.find(b"#", first.start(), line.end())
            coordinates = [w for w in itertools.islice(words, 3) if not 0 <= comment < w.start()]
            layout.add_words(coordinates, vertex)
            vertex += 1
    return layout


# STL

STL_PIECE = re.compile(
    rb"(?<![^\r\n])[ \t]*(?:end)?solid\b[^\r\n]*"
    rb"|\b(?P<word>vertex|normal)\s+(?P<x>\S+)\s+(?P<y>\S+)\s+(?P<z>\S+)", re.IGNORECASE)


def is_binary_stl(data):
    """By the size that the count of facets asks for; "solid" may open a binary file too."""
    if len(data) < 84:
        return False
    size = 84 + 50 * struct.unpack_from("<I", data, 80)[0]
    opens_as_text = data[:5].lower() == b"solid"
    return size == len(data) or size < len(data) and not opens_as_text and b"\0" in data[:1000]


def parse_stl(data):
    return parse_binary_stl(data) if is_binary_stl(data) else parse_ascii_stl(data)


def parse_binary_stl(data):
    layout = Layout(data, noun="corners")
    for facet in range(struct.unpack_from("<I", data, 80)[0]):
        at = 84 + 50 * facet
        layout.add_row(at, Binary("<f"), ~facet)
        for corner in range(3):
            layout.add_row(at + 12 + 12 * corner, Binary("<f"), 3 * facet + corner)
        layout.corners.append(range(3 * facet, 3 * facet + 3))
    return layout


def parse_ascii_stl(data):
    layout = Layout(data, noun="corners")
    vertex = 0
    for piece in STL_PIECE.finditer(data):
        if piece["word"] is None:
            continue
        if piece["word"].lower() == b"normal":
            layout.corners.append([])
            owner = ~(len(layout.corners) - 1)
        elif layout.corners:
            layout.corners[-1].append(vertex)
            owner = vertex
            vertex += 1
        else:
            raise Unreadable("a vertex comes before the first facet")
        for name in "xyz":
            layout.add(*piece.span(name), PLAIN_WORD, owner)
    return layout


# OFF

OFF_KEYWORD = re.compile(rb"(ST)?(C)?(N)?(4)?(n)?OFF")


def lines_of_words(words, data):
    """The words in groups of a line each."""
    group = []
    for word in words:
        if group and re.search(rb"[\r\n]", data[group[-1].end():word.start()]):
            yield group
            group = []
        group.append(word)
    if group:
        yield group


def parse_off(data):
    layout = Layout(data)
    words = words_of(data, 0, b"#")
    keyword = OFF_KEYWORD.fullmatch(take(words, 1)[0][0])
    dimension = 4 if keyword[4] else 3
    first = take(words, 1)[0]
    if first[0].upper() == b"BINARY":
        raise Unreadable("binary OFF is not known here")
    if keyword[5]:
        dimension += int(first[0]) - 3
        first = take(words, 1)[0]
    count = int(first[0])
    last = take(words, 2)[1]
    rows = list(itertools.islice(lines_of_words(words_of(data, last.end(), b"#"), data),
                                 max(count, 0)))
    widths = {len(row) for row in rows}
    if len(rows) < count or len(widths) > 1 or widths and min(widths) < dimension:
        stride = dimension * (2 if keyword[3] else 1) + (4 if keyword[2] else 0)
        stride += 2 if keyword[1] else 0
        words = words_of(data, last.end(), b"#")
        rows = (take(words, stride) for _ in range(count))
    for vertex, row in enumerate(rows):
        layout.add_words(row[:min(dimension, 3)], vertex)
    return layout


# PLY

PLY_CODES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
             "float": "f", "double": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
             "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def ply_header(data):
    """The format, the elements as (name, count, properties), and where the body starts."""
    newline = re.match(rb"ply[ \t]*(\r\n|\n|\r)", data)
    end = re.compile(rb"(?<![^\r\n])end_header[ \t]*").search(data)
    if not newline or not end:
        raise Unreadable("the header of the PLY has no end")
    elements = []
    encoding = ""
    for line in data[:end.start()].decode("latin-1").splitlines():
        words = line.split()
        if words[:1] == ["format"]:
            encoding = words[1]
        elif words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append(words[1:])
    # Some programs end only this line with CR LF. In a file of lone CRs a line feed is data.
    pair = newline[1] != b"\r" and data[end.end():].startswith(b"\r\n")
    return encoding, elements, end.end() + (2 if pair else 1)


def parse_ply(data):
    encoding, elements, start = ply_header(data)
    names = [name for name, _, _ in elements]
    if "vertex" not in names:
        raise Unreadable("there is no element vertex")
    layout = Layout(data)
    elements = elements[:names.index("vertex") + 1]
    if encoding == "ascii":
        add_ascii_ply(layout, elements, words_of(data, start))
    else:
        add_binary_ply(layout, elements, start, "<" if encoding.endswith("little_endian") else ">")
    return layout


def add_ascii_ply(layout, elements, words):
    for name, count, properties in elements:
        for row in range(count):
            for kind, *_, label in properties:
                if kind == "list":
                    take(words, take_integers(words, 1)[0])
                    continue
                word = take(words, 1)
                if name == "vertex" and label in ("x", "y", "z"):
                    layout.add_words(word, row)


def add_binary_ply(layout, elements, at, order):
    for name, count, properties in elements:
        for row in range(count):
            for kind, *types, label in properties:
                if kind == "list":
                    (length,), at = unpack(order + PLY_CODES[types[0]], layout.data, at)
                    at += length * struct.calcsize(PLY_CODES[types[1]])
                    continue
                form = Binary(order + PLY_CODES[kind])
                end = at + struct.calcsize(form.code)
                expect_room(layout.data, at, end - at)
                if name == "vertex" and label in ("x", "y", "z"):
                    layout.add(at, end, form, row)
                at = end


# Gmsh MSH

MSH_NODES = re.compile(rb"(?<![^\r\n])\$(Nodes|NOD|ParametricNodes)[ \t]*(\r\n|\n|\r)")
MSH_COMMENTS = re.compile(rb"\$Comments.*?\$EndComments", re.DOTALL)


def parse_msh(data):
    layout = Layout(data)
    comments = [m.span() for m in MSH_COMMENTS.finditer(data)]
    nodes = next((m for m in MSH_NODES.finditer(data)
                  if not any(a < m.start() < b for a, b in comments)), None)
    if not nodes:
        raise Unreadable("there is no $Nodes")
    file_format = re.search(rb"\$MeshFormat\s+(\S+)\s+(\d)\s+(\d+)[^\r\n]*(\r\n|\n|\r)", data)
    version = float(file_format[1]) if file_format else 1.0
    if file_format and file_format[2] == b"1":
        order = "<" if data[file_format.end():][:4] == b"\1\0\0\0" else ">"
        add = add_binary_msh2 if version < 4 else (
            add_binary_msh40 if version < 4.05 else add_binary_msh41)
        if nodes[1] == b"ParametricNodes":
            add = add_binary_parametric_msh2
        add(layout, nodes.end(), order)
    elif version < 4:
        add_msh2(layout, nodes)
    elif version < 4.05:
        add_msh40(layout, words_of(data, nodes.end()))
    else:
        add_msh41(layout, words_of(data, nodes.end()))
    return layout


def add_msh2(layout, nodes):
    words = words_of(layout.data, nodes.end())
    count = take_integers(words, 1)[0]
    rows = (take(words, 4) for _ in range(count))
    if nodes[1] == b"ParametricNodes":
        rows = itertools.islice(lines_of_words(words, layout.data), count)
    for vertex, row in enumerate(rows):
        layout.add_words(row[1:4], vertex)


def add_msh40(layout, words):
    vertex = 0
    for _ in range(take_integers(words, 2)[0]):
        _, dimension, parametric, count = take_integers(words, 4)
        for _ in range(count):
            row = take(words, 4 + (dimension if parametric else 0))
            layout.add_words(row[1:4], vertex)
            vertex += 1


def add_msh41(layout, words):
    vertex = 0
    for _ in range(take_integers(words, 4)[0]):
        dimension, _, parametric, count = take_integers(words, 4)
        take(words, count)
        for _ in range(count):
            row = take(words, 3 + (dimension if parametric else 0))
            layout.add_words(row[:3], vertex)
            vertex += 1


COUNT_LINE = re.compile(rb"[ \t]*(\d+)[ \t]*(?:\r\n|\n|\r)")


def add_binary_msh2(layout, start, order):
    line = COUNT_LINE.match(layout.data, start)
    expect_room(layout.data, line.end(), 28 * int(line[1]))
    for vertex in range(int(line[1])):
        layout.add_row(line.end() + 28 * vertex + 4, Binary(order + "d"), vertex)


def add_binary_parametric_msh2(layout, start, order):
    """Each vertex names its entity, and has a parameter for each dimension of a curve or face."""
    line = COUNT_LINE.match(layout.data, start)
    at = line.end()
    for vertex in range(int(line[1])):
        (dimension, _), end = unpack(order + "ii", layout.data, at + 28)
        layout.add_row(at + 4, Binary(order + "d"), vertex)
        at = end + (8 * dimension if dimension in (1, 2) else 0)


def add_binary_msh40(layout, at, order):
    (blocks, _), at = unpack(order + "QQ", layout.data, at)
    vertex = 0
    for _ in range(blocks):
        (_, dimension, parametric, count), at = unpack(order + "iiiQ", layout.data, at)
        size = 28 + (8 * dimension if parametric else 0)
        expect_room(layout.data, at, size * count)
        for _ in range(count):
            layout.add_row(at + 4, Binary(order + "d"), vertex)
            at += size
            vertex += 1


def add_binary_msh41(layout, at, order):
    (blocks, _, _, _), at = unpack(order + "QQQQ", layout.data, at)
    vertex = 0
    for _ in range(blocks):
        (dimension, _, parametric, count), at = unpack(order + "iiiQ", layout.data, at)
        size = 24 + (8 * dimension if parametric else 0)
        expect_room(layout.data, at, (8 + size) * count)
        at += 8 * count
        for _ in range(count):
            layout.add_row(at, Binary(order + "d"), vertex)
            at += size
            vertex += 1


# VTK legacy

VTK_POINTS = re.compile(rb"(?<![^\r\n])[ \t]*POINTS\s+(\d+)\s+(\w+)[ \t]*(\r\n|\n|\r|\Z)",
                        re.IGNORECASE)
VTK_CODES = {b"float": "f", b"double": "d", b"int": "i", b"unsigned_int": "I", b"short": "h",
             b"unsigned_short": "H", b"long": "q", b"unsigned_long": "Q", b"char": "b",
             b"unsigned_char": "B", b"vtktypeint64": "q"}


def parse_vtk(data):
    head = re.match(rb"[^\r\n]*(?:\r\n|\n|\r)[^\r\n]*(?:\r\n|\n|\r)\s*(ASCII|BINARY)", data,
                    re.IGNORECASE)
    if not head:
        raise Unreadable("the header says neither ASCII nor BINARY")
    points = VTK_POINTS.search(data, head.end())
    if not points:
        raise Unreadable("there are no POINTS")
    layout = Layout(data)
    count = int(points[1])
    if head[1].upper() == b"ASCII":
        words = words_of(data, points.end())
        for vertex in range(count):
            layout.add_words(take(words, 3), vertex)
        return layout
    form = Binary(">" + VTK_CODES[points[2].lower()])
    size = 3 * struct.calcsize(form.code)
    expect_room(data, points.end(), size * count)
    for vertex in range(count):
        layout.add_row(points.end() + size * vertex, form, vertex)
    return layout


# VTK XML

TAG = re.compile(rb"<!--.*?-->|<\?.*?\?>|<!\[CDATA\[.*?\]\]>|<!.*?>"
                 rb"|<(?P<close>/?)(?P<name>[\w:]+)"
                 rb"(?P<attributes>(?:[^<>\"']|\"[^\"]*\"|'[^']*')*?)(?P<empty>/?)>", re.DOTALL)
ATTRIBUTE = re.compile(rb"([\w:]+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
OFFSET = re.compile(rb"\soffset\s*=\s*[\"'](\d+)[\"'] *")
XML_CODES = {b"Float32": "f", b"Float64": "d"}
DECOMPRESS = {b"vtkZLibDataCompressor": zlib.decompress, b"vtkLZMADataCompressor": lzma.decompress}


def attributes_of(tag):
    return {a[1]: a[2] if a[2] is not None else a[3]
            for a in ATTRIBUTE.finditer(tag["attributes"] or b"")}


class XmlArrays:
    """How arrays of a VTK XML file are encoded."""

    def __init__(self, attributes):
        self.order = ">" if attributes.get(b"byte_order") == b"BigEndian" else "<"
        self.size_code = "Q" if attributes.get(b"header_type") == b"UInt64" else "I"
        self.size = struct.calcsize(self.size_code)
        self.compressor = attributes.get(b"compressor")

    def sizes(self, data):
        """The sizes in front of an array."""
        count = len(data) // self.size
        return struct.unpack(f"{self.order}{count}{self.size_code}", data[:count * self.size])

    def decode(self, data, start, is_base64):
        """What has to be equal in front of an array, its bytes, and where it ends."""
        read = read_base64 if is_base64 else read_raw
        if self.compressor:
            return self.decode_blocks(data, start, read)
        header, end = read(data, start, self.size)
        length = self.sizes(header)[0] if len(header) == self.size else 0
        if is_base64 and data[end - 1:end] != b"=" or not is_base64:
            whole, end = read(data, start, self.size + length)
            return whole[:self.size], whole[self.size:], end
        payload, end = read(data, end, length)
        return header, payload, end

    def decode_blocks(self, data, start, read):
        """The same of a compressed array, of which nothing in front has to be equal."""
        count = self.sizes(read(data, start, 3 * self.size)[0])[0]
        header, at = read(data, start, (3 + count) * self.size)
        sizes = self.sizes(header)[3:]
        packed, end = read(data, at, sum(sizes))
        if self.compressor not in DECOMPRESS:
            raise Unreadable(f"compressor {self.compressor.decode()} is not known here")
        ends = list(itertools.accumulate(sizes, initial=0))
        try:
            payload = b"".join(DECOMPRESS[self.compressor](packed[a:b])
                               for a, b in zip(ends, ends[1:]))
        except (zlib.error, lzma.LZMAError) as error:
            raise Unreadable(f"the points cannot be decompressed: {error}") from error
        return b"", payload, end


def read_raw(data, start, size):
    expect_room(data, start, size)
    return data[start:start + size], start + size


def read_base64(data, start, size):
    """So many bytes, and the place after their whole group of letters."""
    end = start + 4 * -(-size // 3)
    expect_room(data, start, end - start)
    try:
        return base64.b64decode(data[start:end], validate=True)[:size], end
    except binascii.Error as error:
        raise Unreadable(f"base64 at byte {start:,}: {error}") from error


class XmlLayout:
    """Copies a VTK XML file to a layout, with its points decoded."""

    def __init__(self, data):
        self.data = data
        self.copy = bytearray()
        self.layout = Layout(b"")
        self.appended = {}  # offset: (number of the array, its code where it is points)
        self.numbers = 0

    def put(self, start, end):
        """Copies a part that has to be equal."""
        self.layout.origins.append((len(self.copy), start))
        self.copy += self.data[start:end]

    def put_points(self, start, payload, code):
        """Copies decoded points."""
        self.layout.origins.append((len(self.copy), start))
        form = Binary(code)
        size = struct.calcsize(code)
        for at in range(len(self.copy), len(self.copy) + len(payload) // size * size, size):
            self.layout.add(at, at + size, form, self.next_vertex())
        self.copy += payload

    def next_vertex(self):
        self.numbers += 1
        return (self.numbers - 1) // 3

    def put_inline(self, start, end, attributes, arrays):
        """Copies the text of points that stand in their element."""
        text = self.data[start:end]
        if attributes.get(b"format", b"ascii").lower() == b"ascii":
            self.put(start, end)
            shift = len(self.copy) - end
            for word in words_of(self.data, start, end=end):
                self.layout.add(word.start() + shift, word.end() + shift, PLAIN_WORD,
                                self.next_vertex())
            return
        first = start + len(text) - len(text.lstrip())
        self.put(start, first)
        header, payload, after = arrays.decode(self.data, first, True)
        self.copy += header
        self.put_points(first, payload, arrays.order + XML_CODES[attributes[b"type"]])
        self.put(after, end)

    def put_appended(self, start, end, is_base64, arrays):
        """Copies the arrays at the end of the file, in the order in which they are there."""
        offsets = sorted(self.appended)
        self.put(start, start + offsets[0] if offsets else end)
        for offset, following in zip(offsets, offsets[1:] + [end - start]):
            owners = self.appended[offset]
            self.copy += repr([number for number, _ in owners]).encode()
            at = start + offset
            if all(code for _, code in owners):
                header, payload, after = arrays.decode(self.data, at, is_base64)
                self.copy += header
                self.put_points(at, payload, owners[0][1])
                at = after
            self.put(at, start + following)


def parse_vtk_xml(data):
    xml = XmlLayout(data)
    arrays = None
    parents = []
    done = array_count = 0
    for tag in TAG.finditer(data):
        name = tag["name"]
        if name is None:
            continue
        attributes = attributes_of(tag)
        if tag["close"]:
            parents = parents[:-1]
            continue
        if name == b"VTKFile":
            arrays = XmlArrays(attributes)
        elif name == b"DataArray" or name == b"Array":
            is_points = parents[-1:] == [b"Points"]
            if attributes.get(b"format") == b"appended":
                done = put_offset(xml, tag, done, arrays)
                code = arrays.order + XML_CODES[attributes[b"type"]] if is_points else None
                xml.appended.setdefault(int(attributes[b"offset"]), []).append((array_count, code))
            elif is_points and not tag["empty"]:
                xml.put(done, tag.end())
                done = data.index(b"<", tag.end())
                xml.put_inline(tag.end(), done, attributes, arrays)
            array_count += 1
        elif name == b"AppendedData":
            start = data.index(b"_", tag.end()) + 1
            end = data.rindex(b"</AppendedData")
            xml.put(done, start)
            xml.put_appended(start, end, attributes.get(b"encoding") == b"base64", arrays)
            done = end
            break
        if not tag["empty"]:
            parents.append(name)
    xml.put(done, len(data))
    if not xml.layout.coordinates:
        raise Unreadable("there are no Points")
    xml.layout.data = bytes(xml.copy)
    return xml.layout


def put_offset(xml, tag, done, arrays):
    """Copies up to an offset that compressed points may have shifted, and says what comes next.

    That is after the spaces behind it: VTK fills up with them what shorter offsets leave.
    """
    if not arrays.compressor:
        return done
    offset = OFFSET.search(xml.data, tag.start(), tag.end())
    xml.put(done, offset.start(1))
    return offset.end()


# MEDIT

MESHB_DIMENSION, MESHB_VERTICES, MESHB_END = 3, 4, 54


def parse_medit(data):
    layout = Layout(data)
    skip_to(words_of(data, 0, b"#"), b"meshversionformatted")
    words = words_of(data, 0, b"#")
    skip_to(words, b"dimension")
    dimension = take_integers(words, 1)[0]
    skip_to(words, b"vertices")
    for vertex in range(take_integers(words, 1)[0]):
        layout.add_words(take(words, dimension + 1)[:dimension], vertex)
    return layout


def is_meshb(data):
    return (data[:4] in (b"\1\0\0\0", b"\0\0\0\1") and len(data) >= 12
            and 1 <= sum(data[4:8]) <= 4 and sum(data[8:12]) == MESHB_DIMENSION)


def parse_meshb(data):
    layout = Layout(data)
    order = "<" if data[0] == 1 else ">"
    (version,), at = unpack(order + "i", data, 4)
    position = order + ("q" if version >= 3 else "i")
    dimension = 3
    while True:
        (keyword,), at = unpack(order + "i", data, at)
        (following,), at = unpack(position, data, at)
        if keyword == MESHB_DIMENSION:
            (dimension,), _ = unpack(order + "i", data, at)
        elif keyword == MESHB_VERTICES:
            add_meshb_vertices(layout, at, order, version, dimension)
            return layout
        if keyword == MESHB_END or following <= at:
            raise Unreadable("there are no Vertices")
        at = following


def add_meshb_vertices(layout, at, order, version, dimension):
    integer = order + ("q" if version >= 4 else "i")
    form = Binary(order + ("d" if version >= 2 else "f"))
    (count,), at = unpack(integer, layout.data, at)
    size = dimension * struct.calcsize(form.code) + struct.calcsize(integer)
    expect_room(layout.data, at, size * count)
    for vertex in range(count):
        layout.add_row(at + size * vertex, form, vertex, dimension)


# Exodus: netCDF in a classic format

def is_netcdf(data):
    return data[:3] == b"CDF" and data[3:4] in (b"\1", b"\2", b"\5")


class NetcdfHead:
    """Reads the header: dimensions by number, variables as (name, dimensions, type, begin)."""
    SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8, 7: 1, 8: 2, 9: 4, 10: 8, 11: 8}

    def __init__(self, data):
        self.data, self.at = data, 4
        self.count_code = ">q" if data[3] == 5 else ">i"
        self.begin_code = ">i" if data[3] == 1 else ">q"
        self.take(self.count_code)
        self.dimensions = [(self.name(), self.take(self.count_code)) for _ in range(self.listed())]
        self.skip_attributes()
        self.variables = [self.variable() for _ in range(self.listed())]

    def take(self, code):
        (value,), self.at = unpack(code, self.data, self.at)
        return value

    def listed(self):
        self.take(">i")
        return self.take(self.count_code)

    def skip(self, size):
        expect_room(self.data, self.at, size)
        self.at += (size + 3) // 4 * 4

    def name(self):
        size = self.take(self.count_code)
        first = self.at
        self.skip(size)
        return bytes(self.data[first:first + size]).decode("latin-1")

    def skip_attributes(self):
        for _ in range(self.listed()):
            self.name()
            size = self.SIZES[self.take(">i")]
            self.skip(size * self.take(self.count_code))

    def variable(self):
        name = self.name()
        shape = [self.take(self.count_code) for _ in range(self.take(self.count_code))]
        self.skip_attributes()
        kind = self.take(">i")
        self.take(self.count_code)
        return name, shape, kind, self.take(self.begin_code)


def parse_exodus(data):
    layout = Layout(data)
    head = NetcdfHead(data)
    lengths = dict(head.dimensions)
    nodes, dimension = lengths["num_nodes"], lengths["num_dim"]
    arrays = {name: (begin, kind) for name, _, kind, begin in head.variables}
    places = []
    for axis in range(dimension):
        name = "coordx coordy coordz".split()[axis]
        begin, kind = arrays.get(name) or arrays["coord"]
        size = NetcdfHead.SIZES[kind]
        if name not in arrays:
            begin += axis * nodes * size
        expect_room(data, begin, nodes * size)
        places.append((begin, size, Binary(">f" if size == 4 else ">d")))
    for begin, size, form in sorted(places, key=lambda place: place[0]):
        for vertex in range(nodes):
            layout.add_row(begin + size * vertex, form, vertex, 1)
    return layout


# SU2

def parse_su2(data):
    layout = Layout(data)
    dimension = re.search(rb"(?<![^\r\n])\s*NDIME\s*=\s*(\d+)", data, re.IGNORECASE)
    if not dimension:
        raise Unreadable("there is no NDIME")
    vertex = left = 0
    for line in LINE.finditer(data):
        words = list(words_of(data, line.start(), b"%", line.end()))
        if not words:
            continue
        if left:
            layout.add_words(words[:int(dimension[1])], vertex)
            vertex += 1
            left -= 1
        elif words[0][0].upper().startswith(b"NPOIN"):
            left = int(re.search(rb"=\s*(\d+)", line[0])[1])
    if left:
        raise Unreadable("the file ends early, or a count is wrong")
    return layout


# Abaqus and CalculiX

def fields_of(line, start, separator=b","):
    """The places of what stands between commas, without the white space around."""
    for field in line.split(separator):
        first = start + len(field) - len(field.lstrip())
        yield first, first + len(field.strip())
        start += len(field) + len(separator)


def parse_abaqus(data):
    layout = Layout(data)
    vertex = 0
    in_nodes = continued = False
    for line in LINE.finditer(data):
        text = line[0].strip()
        if text.startswith(b"**") or not text:
            continue
        if text.startswith(b"*"):
            in_nodes = re.sub(rb"\s", b"", text.split(b",")[0]).upper() == b"*NODE"
            continued = text.endswith(b",")
        elif continued:
            continued = text.endswith(b",")
        elif in_nodes:
            for start, end in list(fields_of(line[0], line.start()))[1:4]:
                if end > start:
                    layout.add(start, end, FORTRAN_WORD, vertex)
            vertex += 1
    return layout


# Nastran

NASTRAN_GRID = re.compile(rb"GRID(\*?)(?=[ \t,*]|$)", re.IGNORECASE)
NASTRAN_BULK = re.compile(rb"(?<![^\r\n])[ \t]*BEGIN[ \t]+(?:BULK|SUPER)", re.IGNORECASE)


def nastran_fields(line, start, width):
    """The fields behind the name of a card: their places and the form of a coordinate in them."""
    if b"," in line:
        return [(a, b, NASTRAN_WORD) for a, b in fields_of(line, start)][1:]
    if b"\t" in line:
        return tabbed_fields(line, start, width)
    stops = range(8, len(line), width)
    return [(start + s, start + min(s + width, len(line)), Columns(width)) for s in stops]


def tabbed_fields(line, start, width):
    """The same of a line in which tabs go on to the next column that 8 divides."""
    fields = {}
    column = 0
    for at, letter in enumerate(line):
        if letter not in b" \t":
            fields.setdefault((column - 8) // width, []).append(start + at)
        column += 8 - column % 8 if letter == 9 else 1
    last = max(fields)
    return [(places[0], places[-1] + 1, NASTRAN_WORD) if places else (start, start, NASTRAN_WORD)
            for places in (fields.get(number) for number in range(last + 1))]


def parse_nastran(data):
    layout = Layout(data)
    bulk = NASTRAN_BULK.search(data)
    vertex = 0
    is_continued = False  # the card of the line before is a wide GRID, whose z is still to come
    for line in LINE.finditer(data, bulk.end() if bulk else 0):
        text = line[0].split(b"$")[0].rstrip()
        if not text:
            continue
        chosen = []
        grid = NASTRAN_GRID.match(text)
        if grid:
            fields = nastran_fields(text, line.start(), 16 if grid[1] else 8)
            chosen = fields[2:4] if grid[1] else fields[2:5]
            vertex += 1
        elif is_continued and text.startswith(b"*"):
            chosen = nastran_fields(text, line.start(), 16)[:1]
        is_continued = bool(grid and grid[1])
        for start, end, form in chosen:
            if end > start:
                layout.add(start, end, form, vertex - 1)
    return layout


# AVS UCD

UCD_HEAD = re.compile(rb"(?:\s*#[^\r\n]*)*\s*(\d+)[ \t]+\d+[ \t]+\d+[ \t]+\d+[ \t]+\d+[ \t]*[\r\n]")


def parse_ucd(data):
    layout = Layout(data)
    head = UCD_HEAD.match(data)
    words = words_of(data, head.end(), b"#")
    for vertex in range(int(head[1])):
        layout.add_words(take(words, 4)[1:], vertex)
    return layout


# Which format a file is in.

NASTRAN_SUFFIXES = (".bdf", ".nas", ".fem", ".dat", ".pch", ".blk")


def has_line(pattern, data):
    return re.search(rb"(?<![^\r\n])[ \t]*(?:" + pattern + rb")", data, re.IGNORECASE) is not None


def is_off(data, suffix):
    first = next(words_of(data, 0, b"#"), None)
    return first is not None and OFF_KEYWORD.fullmatch(first[0]) is not None


FORMATS = [  # name, parser, whether a file is in it
    ("meshb", parse_meshb, lambda data, suffix: is_meshb(data)),
    ("exodus", parse_exodus, lambda data, suffix: is_netcdf(data)),
    ("ply", parse_ply, lambda data, suffix: re.match(rb"ply\s", data)),
    ("vtk", parse_vtk, lambda data, suffix: data.startswith(b"# vtk DataFile")),
    ("vtk xml", parse_vtk_xml, lambda data, suffix: b"<VTKFile" in data[:2000]),
    ("msh", parse_msh, lambda data, suffix: re.match(rb"\s*\$\w", data) and MSH_NODES.search(data)),
    ("stl", parse_stl, lambda data, suffix: suffix != ".obj" and (
        is_binary_stl(data) or re.match(rb"\s*solid\b", data, re.I) and b"facet" in data.lower())),
    ("medit", parse_medit, lambda data, suffix:
        re.match(rb"(?:\s*#[^\r\n]*)*\s*MeshVersionFormatted", data)),
    ("off", parse_off, is_off),
    ("ucd", parse_ucd, lambda data, suffix: suffix == ".inp" and UCD_HEAD.match(data)),
    ("su2", parse_su2, lambda data, suffix: has_line(rb"NPOIN\s*=", data)),
    ("nastran", parse_nastran, lambda data, suffix: suffix in NASTRAN_SUFFIXES
        or suffix != ".obj" and has_line(rb"BEGIN[ \t]+BULK|GRID[*, ]", data)),
    ("abaqus", parse_abaqus, lambda data, suffix: suffix != ".obj" and has_line(
        rb"\*[ \t]*NODE\b", data)),
    ("obj", parse_obj, lambda data, suffix: suffix == ".obj" or has_line(rb"v[ \t]", data)),
]


def format_of(data, suffix):
    """The name and the parser of the format that a file is in."""
    for name, parse, matches in FORMATS:
        if matches(data, suffix):
            return name, parse
    raise Unreadable("no format known here")


def read_layout(parse, data):
    """Where the coordinates are, with every failure of the parser told as one of the file."""
    try:
        return parse(data)
    except (ValueError, KeyError, IndexError, AttributeError, TypeError, struct.error) as error:
        raise Unreadable(f"not well formed: {error}") from error


# The comparison.

def excerpt(data, at):
    """A few bytes around a place, for people."""
    piece = data[max(at - 8, 0):at + 24]
    return repr(piece)[1:] if piece else "the end of the file"


def expect_same_bytes(before, after, span_before, span_after):
    """Compares what is no coordinate."""
    old, new = before.data[slice(*span_before)], after.data[slice(*span_after)]
    if old == new:
        return
    same = len(os.path.commonprefix([old, new]))
    at = span_before[0] + same
    raise Difference(f"{before.place(at)}: {excerpt(before.data, at)} became "
                     f"{excerpt(after.data, span_after[0] + same)}, which is no coordinate")


def changed_coordinates(before, after):
    """The coordinates that differ. Refuses any other difference."""
    changed = []
    a = b = 0
    for coordinate in before.coordinates:
        start = b + coordinate.start - a
        expect_same_bytes(before, after, (a, coordinate.start), (b, start))
        a = coordinate.end
        b = coordinate.form.end(after.data, start)
        old, new = before.data[coordinate.start:a], after.data[start:b]
        if old == new:
            continue
        for text, which in ((old, "before"), (new, "after")):
            if coordinate.form.value(text) is None:
                raise Difference(f"{before.place(coordinate.start)}: {repr(text)[1:]} is no finite "
                                 f"number ({which})")
        changed.append(coordinate)
    expect_same_bytes(before, after, (a, len(before.data)), (b, len(after.data)))
    return changed


def expect_normals_follow(before, changed):
    """Refuses a normal that changed although no corner of its facet did."""
    moved = {c.vertex for c in changed if c.vertex >= 0}
    for coordinate in changed:
        if coordinate.vertex < 0 and moved.isdisjoint(before.corners[~coordinate.vertex]):
            raise Difference(f"{before.place(coordinate.start)}: the normal of facet "
                             f"{~coordinate.vertex:,} changed, but none of its corners")


def places_of(layout):
    """The place of every corner, by its number."""
    places = {}
    for c in layout.coordinates:
        if c.vertex >= 0:
            value = c.form.value(layout.data[c.start:c.end])
            places.setdefault(c.vertex, []).append(value)
    return places


def expect_corners_together(before, after):
    """Refuses corners of an STL that were at one place and no longer are."""
    new_places = places_of(after)
    moved_to = {}
    for corner, old in places_of(before).items():
        new = new_places[corner]
        if moved_to.setdefault(tuple(old), new) != new:
            raise Difference(f"corner {corner:,} at {old} left the others at its place")


def compare(before, after_data, parse):
    """The coordinates that changed. Refuses any other difference."""
    try:
        after, failure = read_layout(parse, after_data), None
    except Unreadable as error:
        if before.origins:
            raise Difference(f"AFTER: {error}") from error
        after, failure = Layout(after_data), error
    changed = changed_coordinates(before, after)
    if failure:
        raise Difference(f"AFTER: {failure}")
    if after.vertex_count() != before.vertex_count() or (
            len(after.coordinates) != len(before.coordinates)):
        raise Difference(f"{before.vertex_count():,} {before.noun} with "
                         f"{len(before.coordinates):,} coordinates became {after.vertex_count():,} "
                         f"with {len(after.coordinates):,}")
    if before.corners:
        expect_normals_follow(before, changed)
        expect_corners_together(before, after)
    return changed


def contents(path):
    """What a file contains, decompressed, whether it was compressed, and its suffix."""
    data = path.read_bytes()
    is_gzip = data[:2] == b"\x1f\x8b"
    if is_gzip:
        try:
            data = gzip.decompress(data)
        except (OSError, EOFError, zlib.error) as error:
            raise Unreadable(f"{path}: {error}") from error
    suffixes = [suffix.lower() for suffix in path.suffixes if suffix.lower() != ".gz"]
    return data, is_gzip, suffixes[-1] if suffixes else ""


def check(before_path, after_path):
    """The summary of what changed. Refuses any difference that is not in a coordinate."""
    data, is_gzip, suffix = contents(before_path)
    name, parse = format_of(data, suffix)
    before = read_layout(parse, data)
    try:
        after_data, after_is_gzip, _ = contents(after_path)
    except Unreadable as error:
        raise Difference(str(error)) from error
    if is_gzip != after_is_gzip:
        raise Difference("only one of the files is in gzip")
    changed = compare(before, after_data, parse)
    moved = [c for c in changed if c.vertex >= 0]
    normals = len({c.vertex for c in changed if c.vertex < 0})
    also = f" and {normals:,} normals" if normals else ""
    return (f"{name}: {len(moved):,} coordinates of {len({c.vertex for c in moved}):,} "
            f"{before.noun}{also} changed, nothing else")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before", type=pathlib.Path)
    parser.add_argument("after", type=pathlib.Path)
    arguments = parser.parse_args()
    try:
        print(check(arguments.before, arguments.after))
    except Difference as difference:
        print(f"{arguments.after}: {difference}")
        sys.exit(1)
    except Unreadable as error:
        print(f"{arguments.before}: {error}")
        sys.exit(2)


if __name__ == "__main__":
    main()
