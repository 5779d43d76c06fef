"""Messages between robots.

A message is posted (`outbox`) and waits until its sender has sent those before it. At the end of
the cycle in which its transmission begins, `channel_model` decides which receivers it reaches, and
when: as the world is then, and not before the next cycle begins, so that nothing depends on the
order in which programs run. On arrival it goes into the receiver's inbox (`inbox`), until the
program takes it. `messenger` answers the programs' requests; `message_log` records what happens to
each message.
"""
