"""The one error of the add-on: a plain sentence for the user. Whoever raises it has changed nothing."""


class Refusal(Exception):
    pass


class Cancelled(Exception):
    """The user pressed Esc."""
