#!/usr/bin/env python3
"""Turns GLSL files into C arrays: embed.py OUTPUT ROOT FILE...

Each FILE becomes a byte array and a row {name, bytes, size} of tsu_i_snippets, with its path below
ROOT as its name. Bytes, not string literals: some compilers cap those at 16 KiB. Comments stay: the
text that a host pastes is its own manual.
"""
import os
import sys


def main(output, root, files):
    rows = []
    with open(output, 'w', encoding='utf-8') as out:
        out.write('#include "shade/snippet.h"\n\n')
        for i, path in enumerate(files):
            with open(path, 'rb') as source:
                data = source.read()
            name = os.path.relpath(path, root).replace(os.sep, '/')
            out.write(f'static const unsigned char file_{i}[] = {{ // {name}\n')
            for at in range(0, len(data), 16):
                out.write('    ' + ', '.join(str(b) for b in data[at:at + 16]) + ',\n')
            out.write('};\n')
            rows.append(f'    {{"{name}", file_{i}, sizeof file_{i}}},\n')
        out.write('\nconst struct tsu_i_snippet tsu_i_snippets[] = {\n')
        out.write(''.join(rows) + '    {0, 0, 0},\n};\n')


if __name__ == '__main__':
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
