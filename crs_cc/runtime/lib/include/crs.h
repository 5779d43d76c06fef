/* What robots have here beyond the vendor's: devices, and messages from robot to robot.

   It goes with Nclient.h, and with the report's dialect. Lengths are in 0.1 inch, angles in 0.1
   degree, counter-clockwise. A function gives TRUE (1), or FALSE (0) when the robot has no such
   device, unless said otherwise. No connection is needed. docs/crs-h.md has it all. */
#ifndef _CRS_H
#define _CRS_H

/* Where the robot is in the world, by GPS: 0.1 inch. */
int crs_gps(int *x, int *y);

#endif
