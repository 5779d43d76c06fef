/* A robot as kernels see it: the row of its state, in the order of `state/robot_rows.py`, and that
   of its constants, in the order of `RobotKinds.table`. */
#ifndef CRS_KERNELS_ROBOT_H
#define CRS_KERNELS_ROBOT_H

#define AXES 3
#define SONARS 16

/* The profiles of axes, and their progress, see `state/motion_profile.py`. */
struct axes {
    double start[AXES], first[AXES], ramp[AXES], ramp_time[AXES], cruise[AXES], cruise_time[AXES],
        brake_time[AXES], begun[AXES], total[AXES], travelled[AXES], speed[AXES], limit[AXES],
        rate[AXES];
};

struct odometry {
    double shaft[AXES], told[AXES], x, y, heading, turret;
};

struct robot {
    struct axes axes;
    struct odometry odometry;
    double slice[AXES], moved[2], facing, turret, clock;    /* its motion in this cycle */
    double timeout, deadline;                               /* of commands */
    double timer;                                           /* the soonest of its timers */
    double fires, hears;                                    /* its sonars, */
    double echo[SONARS];                                    /* and what they heard */
    long long listening;                                    /* -1 for none */
    double ramp[AXES];                                      /* acceleration of commands */
    double forward, ahead;      /* of one that is hindered: its speed; what encoders do not count */
    double heading, mount, base, distance;
    long long command, command_cycle, requests;
    int pressed;                                            /* its bumpers */
    unsigned char limp[AXES], hindered, slipping, connected;
    double kind;                                            /* the row of its constants, */
    double battery;                                         /* and of its battery, -1 for none */
    double padding[9];          /* a row is an odd number of cache lines, or columns share few */
};

#define CONFIGURATION 7                 /* integers of `State` with position and speeds */

/* Its sonars: their schedule, the ping in the air, and what the last echoes belong to. */
struct sonars {
    long long order[SONARS], length;
    double start, interval;
    long long turn, count, mode;
    double sent, heard, fired[SONARS];
    int sent_from[CONFIGURATION], fired_from[SONARS][CONFIGURATION];
    int padding[9];
};

/* Robots, then the objects that they can push. */
struct body {
    double x, y, velocity[2], angle, spin;
};

/* A battery of motors, which only some robots have. */
struct battery {
    double used, speed[AXES];
};

struct drive {
    double turn[AXES], forward[AXES], true_turn[AXES], true_forward[AXES], count[AXES], turret;
    double unit[AXES];
};

/* Of computers and motors. */
struct supply {
    double start[2], power[2], capacity[2], least;          /* of charge, for the motors */
    double lever[AXES], friction, mass, per_work, stall;
};

struct constants {
    struct drive drive;
    double speed_limit[AXES], is_synchro, has_turret;
    struct supply supply;
    double clock_start, clock_tick;
};

#endif
