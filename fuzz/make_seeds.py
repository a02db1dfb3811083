#!/usr/bin/python3
"""Makes the binary seeds again (fuzz/seeds/image, zae) and the short texts (numbers, uri, curve); needs python3-pil.

The .dae seeds are written by hand; the loader's own fixtures are copied beside them."""
import gzip
import io
import pathlib
import shutil
import struct
import zipfile

from PIL import Image

HERE = pathlib.Path(__file__).parent
SEEDS = HERE / "seeds"


def put(target, name, data):
    path = SEEDS / target / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(data if isinstance(data, bytes) else data.encode())


def pictures():
    rgba = Image.new("RGBA", (5, 3))
    rgba.putdata([(x * 50, y * 80, 128, 255 - 40 * x) for y in range(3) for x in range(5)])
    kinds = {"png": "RGBA", "jpeg": "RGB", "tga": "RGBA", "bmp": "RGB", "gif": "P", "webp": "RGBA"}
    for name, mode in kinds.items():
        out = io.BytesIO()
        rgba.convert(mode).save(out, name)
        put("image", "small." + name, out.getvalue())
    for name, mode in {"grey.png": "L", "palette.png": "P", "deep.png": "I"}.items():
        out = io.BytesIO()
        rgba.convert("L").convert(mode).save(out, "png")
        put("image", name, out.getvalue())
    out = io.BytesIO()
    rgba.convert("RGB").save(out, "jpeg", progressive=True)
    put("image", "progressive.jpeg", out.getvalue())
    out = io.BytesIO()
    rgba.save(out, "tga", compression="tga_rle")
    put("image", "packed.tga", out.getvalue())
    # 8BPS, version 1, 3 channels, 2 x 2, 8 bits, RGB; no colour table, resources or layers; raw
    put("image", "small.psd", b"8BPS" + struct.pack(">H6xHIIHH", 1, 3, 2, 2, 8, 3) + bytes(12) + bytes(2)
        + bytes(range(0, 240, 20)))
    put("image", "small.hdr", b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" + bytes(range(100, 116)))


def archives():
    document = (HERE / "../tests/fixtures/geometry-concave.dae").read_bytes()
    manifest = b'<?xml version="1.0"?><dae_root>models/a.dae</dae_root>'
    for name, packing in {"stored": zipfile.ZIP_STORED, "deflated": zipfile.ZIP_DEFLATED}.items():
        out = io.BytesIO()
        with zipfile.ZipFile(out, "w", packing) as archive:
            archive.writestr(zipfile.ZipInfo("manifest.xml"), manifest, packing)
            archive.writestr(zipfile.ZipInfo("models/a.dae"), document[:900], packing)
            archive.writestr(zipfile.ZipInfo("../outside.png"), b"x", packing)
        put("zae", name + ".zae", out.getvalue())
        put("loader", name + ".zae", out.getvalue())
    put("zae", "document.gz", gzip.compress(document, mtime=0))


def texts():
    put("numbers", "spellings", "0 -1 +2.5 .5 1. 1e10 -1E-3 007 1e-310 INF -INF NaN 1,5 0x10 1e400 4294967299 --1 +-1 e5 .")
    put("numbers", "spaces", " \t1\r\n2\v3\f4\n")
    put("numbers", "long", "0.123456789012345678901234567890 340282346638528859811704183484516925440 1e-45 2147483648")
    for i, uri in enumerate(["#id", "../maps/skin%20a.png#x", "file:///C:/a%5Cb.png", "http://host/a?b#c", "a\\b\\c.tga",
                             "other.dae#node", "%", "%4", "%zz", "FILE://host/share/x", "#a%23b", "data:image/png;base64,AA"]):
        put("uri", str(i), uri)
    for kind in range(6):  # two infinities, a time, number of keys, width, tangents, interpolations, numbers
        numbers = [0, 1, 2.5, 4] + [1, 3, -2, 0] + [0.1, 1, 0.6, 2, 2, 3, 3.5, 0] * 2
        put("curve", f"kind{kind}", bytes([kind % 5, (kind + 1) % 5]) + struct.pack("<f", 1.7) + bytes([3, 0, 0])
            + bytes([kind] * 4) + struct.pack(f"<{len(numbers)}f", *numbers))


def documents():
    for fixture in (HERE / "../tests/fixtures").glob("*.dae"):
        shutil.copy(fixture, SEEDS / "loader" / fixture.name)
        # Without what may not stand before a root element: the targets put their own text there.
        text = fixture.read_text()
        put("cut", fixture.name, text[text.index("<COLLADA"):])
        inside = text[text.index("<asset"):text.rindex("</COLLADA>")]
        put("source", fixture.name, inside)


if __name__ == "__main__":
    pictures()
    archives()
    texts()
    documents()
