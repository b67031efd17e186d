"""Jobs in the background, so that Blender stays usable.

No Python runs on other threads: some of Blender's own code assumes that it already holds the interpreter's lock, and crashes
when another thread holds it. A job is a generator. It starts its work in a process or in the module, then yields, each time it is asked, what there is to tell;
True sent to it asks it to end soon with the best that it has. What it returns is the result.
"""

import time
from dataclasses import dataclass

_REST = 0.01  # seconds


@dataclass
class Progress:
    """What a job that runs has to tell."""

    share: float = 0.0  # from 0 to 1
    newest: object = None  # the best map so far, where the job gives any before it ends


class Job:
    """Drives a job, by calls of step()."""

    def __init__(self, steps):
        self.progress = Progress()
        self.running = True
        self.stopping = False
        self.closed = False
        self._steps = steps
        self._result = None
        self._error = None
        self._advance(None)

    def _advance(self, sent):
        try:
            self.progress = self._steps.send(sent)
        except StopIteration as end:
            self.running, self._result = False, end.value
        except Exception as error:  # told by wait()
            self.running, self._error = False, error

    def step(self):
        """Looks after the job. True while it runs."""
        if self.running:
            self._advance(self.stopping)
        return self.running

    def stop(self):
        """Asks the job to end soon with the best that it has."""
        self.stopping = True

    def close(self):
        """Ends the job at once, without a result."""
        self.closed, self.running = True, False
        self._steps.close()

    def wait(self):
        """Waits for the end. Returns the result or raises what the job raised."""
        while self.step():
            time.sleep(_REST)
        if self._error:
            raise self._error
        return self._result
