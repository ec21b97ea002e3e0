"""Reads binary G-code (.bgcode). It is written only from libbgcode's specification and the formats of heatshrink and
MeatPack, as an oracle for the writer in common/gcode/binary.

    blocks = read(bytes)        list of Block, checksums verified; raises ValueError for any deviation from the specification
    text(blocks)                the program, as decoded from MeatPack
    entries(block)              the key=value lines of a metadata block
"""
import collections
import struct
import zlib

Block = collections.namedtuple("Block", "type compression parameters data")
FILE_METADATA, GCODE, SLICER_METADATA, PRINTER_METADATA, PRINT_METADATA, THUMBNAIL = range(6)
PARAMETERS = {THUMBNAIL: 3}  # number of 16-bit words; 1 for all other block types
PACKED = "0123456789. \nGX"


def need(condition, what):
    if not condition:
        raise ValueError(what)


class Reader:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, count):
        need(self.at + count <= len(self.data), "the file ends too early")
        self.at += count
        return self.data[self.at - count : self.at]

    def number(self, form):
        return struct.unpack("<" + form, self.take(struct.calcsize(form)))[0]


def heatshrink(data, size, window_bits, length_bits):
    """Decompresses heatshrink data bit by bit. A 1 bit begins a literal byte. A 0 bit begins a back reference: distance
    and count.
    """
    bits = "".join(f"{byte:08b}" for byte in data)
    out, at = bytearray(), 0

    def number(count):
        nonlocal at
        need(at + count <= len(bits), "heatshrink ends too early")
        at += count
        return int(bits[at - count : at], 2)

    while len(out) < size:
        if number(1):
            out.append(number(8))
            continue
        back, count = number(window_bits) + 1, number(length_bits) + 1
        need(back <= len(out), "heatshrink looks back beyond its beginning")
        for _ in range(count):
            out.append(out[-back])
    need(len(out) == size, "heatshrink makes more than its size")
    need(len(bits) - at < 8 and "1" not in bits[at:], "heatshrink does not end where its data do")
    return bytes(out)


def decompress(kind, data, size):
    if kind == 1:
        data = zlib.decompress(data)
    elif kind in (2, 3):
        data = heatshrink(data, size, 11 if kind == 2 else 12, 4)
    else:
        need(kind == 0, f"compression {kind}")
    need(len(data) == size, "a block has another size than its header says")
    return data


def read(data):
    reader = Reader(data)
    need(reader.take(4) == b"GCDE", "no binary G-code")
    need(reader.number("I") == 1, "another version")
    checksum = reader.number("H")
    need(checksum in (0, 1), "another checksum")
    blocks = []
    while reader.at < len(data):
        begin = reader.at
        kind, compression, size = reader.number("H"), reader.number("H"), reader.number("I")
        need(kind <= THUMBNAIL, f"block type {kind}")
        stored = reader.number("I") if compression else size
        parameters = [reader.number("H") for _ in range(PARAMETERS.get(kind, 1))]
        payload = reader.take(stored)
        if checksum:
            need(zlib.crc32(data[begin : reader.at]) == reader.number("I"), "a checksum is wrong")
        blocks.append(Block(kind, compression, parameters, decompress(compression, payload, size)))
    check_order([block.type for block in blocks])
    return blocks


def check_order(types):
    order = [FILE_METADATA, PRINTER_METADATA, THUMBNAIL, PRINT_METADATA, SLICER_METADATA, GCODE]
    ranks = [order.index(kind) for kind in types]
    need(ranks == sorted(ranks), "the blocks are in another order")
    for kind in (PRINTER_METADATA, PRINT_METADATA, SLICER_METADATA):
        need(types.count(kind) == 1, f"not one block of type {kind}")


def unpack(data):
    """Decodes MeatPack. A signal is two bytes 0xff and a command; the nibble 15 means that a whole character follows."""
    out, at, packs, spaces = [], 0, False, True
    while at < len(data):
        if data[at : at + 2] == b"\xff\xff":
            command = data[at + 2]
            need(command in (0xFB, 0xFA, 0xF9, 0xF7, 0xF6), f"MeatPack command {command}")
            if command in (0xF7, 0xF6):
                spaces = command == 0xF6
            else:
                packs = command == 0xFB
            at += 3
            continue
        byte = data[at]
        at += 1
        if not packs:
            out.append(chr(byte))
            continue
        for nibble in (byte & 15, byte >> 4):
            if nibble == 15:
                out.append(chr(data[at]))
                at += 1
            else:
                out.append("E" if nibble == 11 and not spaces else PACKED[nibble])
    return "".join(out).encode("latin-1").decode()


def text(blocks):
    """Returns the text of all G-code blocks. Each block is decoded independently, as by a printer that is switched on
    again.
    """
    parts = []
    for block in blocks:
        if block.type != GCODE:
            continue
        encoding = block.parameters[0]
        need(encoding in (0, 1, 2), f"G-code encoding {encoding}")
        parts.append(block.data.decode() if encoding == 0 else unpack(block.data))
    return "".join(parts)


def entries(block):
    need(block.parameters == [0], "metadata that are no INI")
    return dict(line.split("=", 1) for line in block.data.decode().splitlines())
