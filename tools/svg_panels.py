"""Log-log panels as SVG, for the chart scripts beside this file."""
import math

STYLE = ("text{font-family:sans-serif;fill:#222}.title{font-size:15px;font-weight:bold}.label{font-size:12px;"
         "text-anchor:middle}.tick{font-size:11px;text-anchor:middle}.end{text-anchor:end}.start{text-anchor:start}"
         ".grid{stroke:#ddd}.zero{stroke:#31a354;stroke-dasharray:4 3}")


def document(width, height, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}"><style>{STYLE}</style>'
            f'<rect width="100%" height="100%" fill="white"/>{"".join(parts)}</svg>\n')


def shape(kind, x, y, color):
    r = 4.5
    corners = {"square": [(-1, -1), (1, -1), (1, 1), (-1, 1)], "triangle": [(0, -1.2), (1.1, 0.9), (-1.1, 0.9)],
               "down": [(0, 1.2), (1.1, -0.9), (-1.1, -0.9)], "diamond": [(0, -1.3), (1.3, 0), (0, 1.3), (-1.3, 0)],
               "hexagon": [(-1.1, 0), (-0.55, -1), (0.55, -1), (1.1, 0), (0.55, 1), (-0.55, 1)],
               "star": [(0, -1.4), (0.35, -0.4), (1.4, -0.4), (0.55, 0.2), (0.9, 1.2), (0, 0.6), (-0.9, 1.2), (-0.55, 0.2),
                        (-1.4, -0.4), (-0.35, -0.4)]}
    if kind in corners:
        points = " ".join(f"{x + r * a:.1f},{y + r * b:.1f}" for a, b in corners[kind])
        return f'<polygon points="{points}" fill="{color}" fill-opacity="0.8" stroke="white" stroke-width="0.5"/>'
    if kind == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{r}" fill="{color}" fill-opacity="0.8" stroke="white" stroke-width="0.5"/>'
    d = r if kind == "plus" else r * 0.75
    lines = [(-d, 0, d, 0), (0, -d, 0, d)] if kind == "plus" else [(-d, -d, d, d), (-d, d, d, -d)]
    return "".join(f'<line x1="{x + a:.1f}" y1="{y + b:.1f}" x2="{x + c:.1f}" y2="{y + e:.1f}" stroke="{color}" '
                   'stroke-width="2"/>' for a, b, c, e in lines)


class Panel:
    """A log-log panel; values of zero lie on a line of their own below the axis."""

    def __init__(self, left, title, x_label, y_label, x_values, y_values):
        self.left, self.top, self.width, self.height = left, 50, 380, 340
        self.x_range = self.decades(x_values)
        self.y_range = self.decades(y_values)
        self.parts = [f'<text x="{left}" y="28" class="title">{title}</text>',
                      f'<text x="{left + self.width / 2}" y="{self.top + self.height + 58}" class="label">{x_label}</text>',
                      f'<text x="{left - 58}" y="{self.top + self.height / 2}" class="label" '
                      f'transform="rotate(-90 {left - 58} {self.top + self.height / 2})">{y_label}</text>']
        for decade in range(self.x_range[0], self.x_range[1] + 1):
            x = self.x(10.0 ** decade)
            self.parts.append(f'<line x1="{x:.1f}" y1="{self.top}" x2="{x:.1f}" y2="{self.top + self.height + 24}" class="grid"/>'
                              f'<text x="{x:.1f}" y="{self.top + self.height + 40}" class="tick">{10.0 ** decade:g}</text>')
        for decade in range(self.y_range[0], self.y_range[1] + 1):
            y = self.y(10.0 ** decade)
            self.parts.append(f'<line x1="{left}" y1="{y:.1f}" x2="{left + self.width}" y2="{y:.1f}" class="grid"/>'
                              f'<text x="{left - 6}" y="{y + 4:.1f}" class="tick end">{10.0 ** decade:g}</text>')
        if any(value == 0 for value in y_values):
            y = self.y(0)
            self.parts.append(f'<line x1="{left}" y1="{y}" x2="{left + self.width}" y2="{y}" class="zero"/>'
                              f'<text x="{left - 6}" y="{y + 4}" class="tick end">0</text>')

    @staticmethod
    def decades(values):
        logs = [math.log10(value) for value in values if value > 0]
        return (math.floor(min(logs)), math.ceil(max(logs) + 1e-9)) if logs else (0, 1)

    def x(self, value):
        low, high = self.x_range
        return self.left + self.width * (math.log10(max(value, 10.0 ** low)) - low) / (high - low)

    def y(self, value):
        low, high = self.y_range
        if value <= 0:
            return self.top + self.height + 20
        return self.top + self.height * (1 - (math.log10(value) - low) / (high - low))
