"""Terminal colours."""


class AnsiCodes:
    RESET, BOLD, UNDERLINE = "\x1b[0m", "\x1b[1m", "\x1b[4m"
    CLEAR_SCREEN = "\x1b[2J"


for _number, _colour in enumerate(("BLACK", "RED", "GREEN", "YELLOW", "BLUE", "MAGENTA", "CYAN", "WHITE")):
    setattr(AnsiCodes, _colour + "_FOREGROUND", f"\x1b[{30 + _number}m")
    setattr(AnsiCodes, _colour + "_BACKGROUND", f"\x1b[{40 + _number}m")
