"""Points and lines on logarithmic axes, as SVG: what the scripts that draw plots share."""

import math


class Plot:
    LEFT, TOP, WIDTH, HEIGHT = 70, 50, 480, 340
    COLOURS = ["#1b6ca8", "#c44e1f", "#3a7d34", "#7b4fa0", "#8a6d1d", "#00838f", "#666"]

    def __init__(self, title, x_name, x_range, y_range, y_name="T, cycles", x_ticks=None,
                 legend_width=150):
        self.x_range, self.y_range = x_range, y_range
        self.legend, self.legend_width = 0, legend_width
        self.parts = [self.text(self.LEFT, 24, title, size=15)]
        bottom, right = self.TOP + self.HEIGHT, self.LEFT + self.WIDTH
        for x in x_ticks or self.ticks(*x_range):
            self.parts.append(self.line([(self.x(x), self.TOP), (self.x(x), bottom)], "#ddd"))
            self.parts.append(self.text(self.x(x), bottom + 18, str(x), anchor="middle"))
        for y in self.ticks(*y_range):
            self.parts.append(self.line([(self.LEFT, self.y(y)), (right, self.y(y))], "#ddd"))
            self.parts.append(self.text(self.LEFT - 8, self.y(y) + 4, str(y), anchor="end"))
        self.parts.append(self.text(self.LEFT + self.WIDTH / 2, bottom + 38, x_name, anchor="middle"))
        self.parts.append(self.text(16, self.TOP - 12, y_name))

    @staticmethod
    def ticks(first, last):
        """1, 2 and 5 times the powers of ten; the powers alone where that would be a crowd."""
        steps = (1, 2, 5) if last < 10**4 * first else (1,)
        powers = range(math.floor(math.log10(first)), math.ceil(math.log10(last)) + 1)
        return [m * 10**e for e in powers for m in steps if first <= m * 10**e <= last]

    @staticmethod
    def text(x, y, words, size=12, anchor="start"):
        return f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}">{words}</text>'

    @staticmethod
    def line(points, colour, dash="none"):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        return f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.4" stroke-dasharray="{dash}"/>'

    @staticmethod
    def share(value, first, last):
        return math.log(value / first) / math.log(last / first)

    def x(self, value):
        return self.LEFT + self.WIDTH * self.share(value, *self.x_range)

    def y(self, value):
        return self.TOP + self.HEIGHT * (1 - self.share(value, *self.y_range))

    def label(self, words, sample):
        y = self.TOP + 16 + 18 * self.legend
        left = self.LEFT + self.WIDTH + 14
        self.parts.append(sample(left, y - 4))
        self.parts.append(self.text(left + 26, y, words))
        self.legend += 1

    def curve(self, points, words, colour, dash="none"):
        stroke = self.COLOURS[colour]
        self.parts.append(self.line([(self.x(a), self.y(b)) for a, b in sorted(points.items())], stroke, dash))
        self.label(words, lambda x, y: self.line([(x, y), (x + 20, y)], stroke, dash))

    def dots(self, points, words, colour, filled=False):
        stroke = self.COLOURS[colour]

        def dot(x, y):
            return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{stroke if filled else "none"}" stroke="{stroke}"/>'

        self.parts += [dot(self.x(a), self.y(b)) for a, b in points.items()]
        self.label(words, lambda x, y: dot(x + 10, y))

    def save(self, path):
        width, height = self.LEFT + self.WIDTH + self.legend_width, self.TOP + self.HEIGHT + 55
        with open(path, "w") as file:
            file.write(
                f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif">\n'
                f'<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(self.parts) + "\n</svg>\n"
            )
