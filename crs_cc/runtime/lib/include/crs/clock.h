/* Simulated time, for the library itself. */
#ifndef CRS_CLOCK_H
#define CRS_CLOCK_H

#define CRS_START 946684800L   /* of every run: 1 January 2000, 00:00:00 UTC, in Unix time */

/* Returns seconds since the start of the run, and the processor time used. */
double __crs_now(double *processor_s);

/* Waits. An alarm ends it early; returns the seconds that are left then. */
double __crs_pass(double seconds);

/* When the next alarm is due, in seconds since the start of the run; infinite for none. */
extern double __crs_alarm_s;

/* Called after requests, to deliver an alarm that has become due; null when none was ever set. */
extern void (*__crs_after_request)(void);

#endif
