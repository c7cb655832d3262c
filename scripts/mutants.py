"""Every way to break one thing in a module's source, and one source that has them all.

The source with all mutants (a schema) is compiled once; a variable of each instance, taken from RC2_MUTANT in the
environment when the simulation begins, says which mutant is in force (0: none).

An operator becomes its neighbour, a constant one more or less, a negation or a complement is left out, a condition
turned round, a register not written.
"""

import collections
import re

from sv_walk import Walk

Mutant = collections.namedtuple("Mutant", "number unit line before after")  # before, after: the statement
SWAPS = {"+": "-", "-": "+", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==", "&&": "||", "||": "&&",
         "&": "|", "|": "&", "^": "&", "<<": ">>", ">>": "<<", "<<<": ">>>", ">>>": "<<<"}
CHOICE = r'$c32("std::getenv(\"RC2_MUTANT\") == nullptr ? 0 : std::atoi(std::getenv(\"RC2_MUTANT\"))")'
OPERAND_ENDS = re.compile(r"[\w$')\]}]")  # a binary operator stands after one


def other_constants(text, in_index):
    """A constant one up and one down. In an index only the one that is surely there."""
    if text in ("'0", "'1"):
        return ["'1" if text == "'0" else "'0"]
    width, base, digits = re.fullmatch(r"(?:(\d*)'s?([bdh]))?([0-9a-fA-F_]+)", text).groups()
    radix = {"b": 2, "h": 16}.get(base, 10)
    value = int(digits.replace("_", ""), radix)
    if in_index:
        values = [value - 1 if value else 1]
    else:
        top = 1 << int(width) if width else None
        values = [v for v in (value + 1, value - 1) if v >= 0 and (top is None or v < top)]
    shown = {2: "{:b}", 16: "{:x}", 10: "{}"}[radix]
    return [(f"{width}'{base}" if base else "") + shown.format(v) for v in values]


class Source(Walk):
    """A module's source, its mutants and its schema."""

    def __init__(self, unit, text, first):
        super().__init__(text)
        self.unit, self.whole, self.next = unit, text, first
        self.mutants, self.edits = [], []
        self.walk()

    def schema(self):
        text = self.whole
        for start, end, new in sorted(self.edits, reverse=True):
            text = text[:start] + new + text[end:]
        return text

    def meet_header(self, end):
        after = self.tokens[end - 1].end
        self.edits.append((after, after, f"\n  int unsigned mutant;\n  initial mutant = {CHOICE};\n"))

    def add(self, first, last, after):
        line = self.text.count("\n", 0, self.tokens[first].start) + 1
        squeeze = lambda text: " ".join(text.split())
        self.mutants.append(Mutant(self.next, self.unit, line, squeeze(self.words(first, last)), squeeze(after)))
        self.next += 1
        return self.next - 1

    def meet_register(self, first, last):
        number = self.add(first, last, "(not written)")
        self.edits.append((self.tokens[first].start, self.tokens[first].start, f"begin if (mutant != {number}) "))
        self.edits.append((self.tokens[last - 1].end, self.tokens[last - 1].end, " end"))

    def meet_expression(self, first, last, statement, end, condition):
        if first == last:
            return
        start, stop = self.tokens[first].start, self.tokens[last - 1].end
        before, behind = self.text[self.tokens[statement].start:start], self.text[stop:self.tokens[end - 1].end] if end > last else ""
        choice = ""
        for expression in self.variants(first, last, condition):
            number = self.add(statement, end, before + expression + behind)
            choice += f"(mutant == {number}) ? ({expression}) : "
        if choice:
            self.edits.append((start, stop, f"{choice}({self.text[start:stop]})"))

    def variants(self, first, last, condition):
        start, stop = self.tokens[first].start, self.tokens[last - 1].end
        whole = self.text[start:stop]

        def changed(low, high, new):
            return whole[:low - start] + new + whole[high - start:]

        # A condition of one comparison or negation is turned round by what follows.
        texts = [token.text for token in self.tokens[first:last]]
        if condition and ("&&" in texts or "||" in texts or not {"!", "==", "!=", "<", ">", "<=", ">="} & set(texts)):
            yield f"!({whole})"
        brackets = []
        for i in range(first, last):
            token, before = self.tokens[i], self.tokens[i - 1].text
            binary = i > first and OPERAND_ENDS.match(before[-1]) and before not in ("return",)
            if token.text in "([{":
                ends = self.closes(i) if token.text == "(" else ""
                width = ends == ")'" or (ends == "){" and before == "{")
                brackets.append("width" if width else token.text)
            elif token.text in ")]}":
                brackets.pop()
            elif "width" in brackets:
                continue  # of a cast, or how often something is repeated
            elif "[" in brackets and (before, self.tokens[i + 1].text) != ("[", "]"):
                continue  # what is reckoned in an index is where a slice or a word ends: mostly not there
            elif token.text in SWAPS and (binary or token.text in "&|"):
                yield changed(token.start, token.end, SWAPS[token.text])
            elif token.text in ("!", "~", "-") and not binary:
                yield changed(token.start, token.end, "")
            elif token.text == "?":
                low = self.condition_start(i, first)
                yield changed(self.tokens[low].start, token.start, f"!({self.words(low, i)}) ")
            elif re.match(r"\d|'[01]", token.text) and before != "'" and self.tokens[i + 1].text != "'":
                if brackets and brackets[-1] == "{" and self.tokens[i + 1].text == "{":
                    continue  # a count of copies
                for constant in other_constants(token.text, "[" in brackets):
                    yield changed(token.start, token.end, constant)

    def closes(self, i):
        """The bracket that closes the one at token i, and what follows it."""
        depth = 0
        while True:
            depth += (self.tokens[i].text in "([{") - (self.tokens[i].text in ")]}")
            i += 1
            if not depth:
                return self.tokens[i - 1].text + self.tokens[i].text

    def condition_start(self, i, first):
        depth = 0
        while i > first:
            before = self.tokens[i - 1].text
            if not depth and before in ("(", "[", "{", ",", "?", ":"):
                break
            depth += (before in ")]}") - (before in "([{")
            i -= 1
        return i
