/* Simulated time, for the library itself. */
#ifndef CRS_CLOCK_H
#define CRS_CLOCK_H

#define CRS_START 946684800L   /* of every run: 1 January 2000, 00:00:00 UTC, in Unix time */

/* Returns seconds since the start of the run, and the processor time used. */
double __crs_now(double *processor_s);

/* Waits. An alarm interrupts it; returns the remaining seconds. */
double __crs_pass(double seconds);

/* Time of the next alarm, in seconds since the start of the run; infinite for none. */
extern double __crs_alarm_s;

/* Called after requests to deliver due alarms; null if none was ever set. */
extern void (*__crs_after_request)(void);

#endif
