"""Jobs on a thread, so that Blender stays usable."""

import threading


class Job:
    """Runs a function on a thread: work(watch), where watch(share, newest=None) takes a share from 0 to 1, or None when
    there is none to tell, and the best map so far, and returns False once the job is to stop with the best that it has."""

    def __init__(self, work):
        self.share = 0.0
        self.newest = None  # the best map so far, where the job gives any before it ends
        self.result = None
        self.error = None
        self._stop = threading.Event()
        self._thread = threading.Thread(target=self._run, args=(work,), daemon=True)
        self._thread.start()

    def _run(self, work):
        try:
            self.result = work(self._watch)
        except Exception as error:  # it is told on the main thread
            self.error = error

    def _watch(self, share, newest=None):
        if share is not None:
            self.share = share
        if newest is not None:
            self.newest = newest
        return not self._stop.is_set()

    def stop(self):
        """Asks the job to end soon with the best that it has."""
        self._stop.set()

    @property
    def stopping(self):
        return self._stop.is_set()

    @property
    def running(self):
        return self._thread.is_alive()

    def join(self):
        """Waits for the end."""
        self._thread.join()

    def wait(self):
        """Waits for the end. Returns the result or raises what the job raised."""
        self.join()
        if self.error:
            raise self.error
        return self.result
