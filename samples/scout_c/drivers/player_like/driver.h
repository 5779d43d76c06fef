/*
 * driver.h - a driver as the device server sees it: a table of functions, and the
 * interfaces whose data it fills. Metres, radians, seconds.
 */

# ifndef DRIVER_H
# define DRIVER_H

# define MAX_RANGES  16

typedef struct { double px, py, pa, vx, va; int stall; } position_data;
typedef struct { int count; float ranges[MAX_RANGES]; } ranger_data;
typedef struct { int count; unsigned char bumpers[20]; } bumper_data;
typedef struct { float volts; } power_data;

typedef struct driver driver;

struct driver {
    char *name;
    int (*setup)();                 /* driver, argc, argv */
    int (*shutdown)();              /* driver */
    int (*update)();                /* driver: reads the robot into the members below */
    int (*command)();               /* driver, vx, va: both double */
    position_data position;
    ranger_data sonar, ir;
    bumper_data bumper;
    power_data power;
    long updates, failures;
};

extern driver nomad_driver;

# endif
