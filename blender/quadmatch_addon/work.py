"""Long work: in a thread while Blender stays awake, with progress and Esc; straight in scripts and background mode.

An operator gives three methods: `gather` reads Blender's data and refuses what will not do, `compute` works on arrays
alone, `apply` writes. Only `compute` runs in the thread.
"""
import threading

from .refusal import Cancelled, Refusal

POLL_SECONDS = 0.05
#: Events that only look: they go on to the viewport meanwhile.
LOOKING = {"MIDDLEMOUSE", "WHEELUPMOUSE", "WHEELDOWNMOUSE", "MOUSEMOVE", "TRACKPADPAN", "TRACKPADZOOM"}


class Task:
    """A computation in a thread."""

    def __init__(self, compute):
        self.matched = self.most = 0
        self.result = self.error = None
        self._cancelled = False
        self._thread = threading.Thread(target=self._run, args=(compute,), daemon=True)
        self._thread.start()

    def _run(self, compute):
        try:
            self.result = compute(self._progress)
        except Exception as error:  # handed on to the thread of Blender
            self.error = error

    def _progress(self, matched, most):
        self.matched, self.most = matched, most
        return not self._cancelled

    @property
    def running(self):
        return self._thread.is_alive()

    @property
    def share(self):
        return self.matched / self.most if self.most else 0.0

    def cancel(self):
        self._cancelled = True

    def outcome(self):
        if self._cancelled:  # even if it ended before it heard of it
            raise Cancelled()
        if self.error is not None:
            raise self.error
        return self.result


class Working:
    """Mixed into operators."""

    def execute(self, context):
        return self._guarded(context, lambda: self._finish(context, self._started(context)(lambda matched, most: True)))

    def invoke(self, context, event):
        return self._guarded(context, lambda: self._begin(context))

    def modal(self, context, event):
        if event.type == "ESC" and event.value == "PRESS":
            self._task.cancel()
            context.workspace.status_text_set("quadmatch: stopping …")
        if event.type != "TIMER":
            return {"PASS_THROUGH"} if event.type in LOOKING else {"RUNNING_MODAL"}
        if self._task.running:
            context.window_manager.progress_update(100 * self._task.share)
            context.workspace.status_text_set(f"quadmatch: {self._task.matched:,} faces, Esc cancels")
            return {"RUNNING_MODAL"}
        self._clear(context)
        return self._guarded(context, lambda: self._finish(context, self._task.outcome()))

    def cancel(self, context):
        """Blender ends it, say because a file is loaded."""
        self._task.cancel()
        self._clear(context)

    def _started(self, context):
        self._gathered = self.gather(context)
        return lambda progress: self.compute(self._gathered, progress)

    def _begin(self, context):
        self._task = Task(self._started(context))
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self._timer = manager.event_timer_add(POLL_SECONDS, window=context.window)
        manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def _clear(self, context):
        context.window_manager.event_timer_remove(self._timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def _finish(self, context, result):
        lines = self.apply(context, self._gathered, result)
        context.scene.quadmatch.report = "\n".join(lines)
        self.report({"INFO"}, f"{self.bl_label}: {lines[0]}")
        for area in (area for window in context.window_manager.windows for area in window.screen.areas):
            area.tag_redraw()
        return {"FINISHED"}

    def _guarded(self, context, action):
        try:
            return action()
        except Refusal as refusal:
            self.report({"ERROR"}, f"{refusal}.")
        except Cancelled:
            self.report({"WARNING"}, f"{self.bl_label}: cancelled, nothing is changed.")
        return {"CANCELLED"}
