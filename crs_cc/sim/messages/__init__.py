"""Messages from robot to robot.

A message is posted (`outbox`), where it waits until its sender has sent those before it. At the end
of the cycle in which its transmission begins, `air` decides whom it reaches, and when: as things
stand then, and not before the next cycle begins, so that nothing depends on which of two programs
was run first. On its arrival it goes into the receiver's inbox (`inbox`), until the program takes
it. `messenger` answers the programs' requests; `traffic` has a record of all that happens.
"""
