"""Messages that Foxglove and similar programs display directly: scenes, point clouds, logs.

The schemas here are those of npm's @foxglove/schemas 2.1.0 (MIT), unchanged.
The licence is that of Foxglove's packages of the same repository; this one names it only.
"""
