/* Signals, for the library itself. */
#ifndef CRS_SIGNALS_H
#define CRS_SIGNALS_H

/* Delivers a signal: runs its handler, or ends the program. */
void __crs_signal(int signal);

/* Returns whether calls go on after the handler of a signal. */
int __crs_restarts(int signal);

/* Waits for an alarm under a mask of blocked signals; returns when one was delivered. */
void __crs_await_signal(unsigned long mask);

/* Replaces the mask of blocked signals; returns the one before. */
unsigned long __crs_swap_mask(unsigned long mask);

/* Runs the handler of SIGABRT if a program has one; null when it cannot have any. */
extern void (*__crs_on_abort)(void);

#endif
