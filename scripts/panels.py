"""Small plots side by side, linear in y from zero on: what a parameter does to a quantity."""


class Panels:
    WIDTH, HEIGHT, LEFT, TOP, GAP = 170, 120, 50, 40, 60
    COLOURS = ("#c44e1f", "#1b6ca8", "#3a7d34")

    def __init__(self, columns, rows, title):
        self.columns, self.rows = columns, rows
        self.parts = [self.text(self.LEFT, 20, title, 14)]

    @staticmethod
    def text(x, y, words, size=11, anchor="start", colour="black"):
        return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" fill="{colour}">{words}</text>'

    def panel(self, column, row, x_name, y_name, curves):
        """curves: name -> {x: y}; the x are ticks at equal distances."""
        left = self.LEFT + column * (self.WIDTH + self.GAP)
        top = self.TOP + 20 + row * (self.HEIGHT + self.GAP)
        bottom = top + self.HEIGHT
        ticks = sorted({x for points in curves.values() for x in points})
        most = 1.1 * max(y for points in curves.values() for y in points.values())
        place = {x: left + self.WIDTH * (i + 0.5) / len(ticks) for i, x in enumerate(ticks)}
        self.parts.append(f'<rect x="{left}" y="{top}" width="{self.WIDTH}" height="{self.HEIGHT}" fill="none" stroke="#999"/>')
        self.parts += [self.text(place[x], bottom + 14, x, anchor="middle") for x in ticks]
        self.parts.append(self.text(left + self.WIDTH / 2, bottom + 28, x_name, anchor="middle"))
        self.parts.append(self.text(left, top - 6, y_name))
        step = next(step for step in (1, 2, 5, 10, 20, 50, 100) if most / step <= 6)
        for y in range(0, int(most) + 1, step):
            height = bottom - self.HEIGHT * y / most
            self.parts.append(f'<line x1="{left}" y1="{height:.1f}" x2="{left + self.WIDTH}" y2="{height:.1f}" stroke="#eee"/>')
            self.parts.append(self.text(left - 4, height + 4, y, 10, "end"))
        for colour, (name, points) in zip(self.COLOURS, curves.items()):
            line = [(place[x], bottom - self.HEIGHT * points[x] / most) for x in sorted(points)]
            self.parts.append(f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in line)}" fill="none" stroke="{colour}"/>')
            self.parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" fill="{colour}"/>' for x, y in line]

    def legend(self, names):
        for i, (colour, name) in enumerate(zip(self.COLOURS, names)):
            self.parts.append(self.text(self.LEFT + 420 + 150 * i, 20, f"● {name}", 12, colour=colour))

    def save(self, path):
        width = self.LEFT + self.columns * (self.WIDTH + self.GAP)
        height = self.TOP + 20 + self.rows * (self.HEIGHT + self.GAP)
        with open(path, "w") as file:
            file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif">\n'
                       f'<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(self.parts) + "\n</svg>\n")
