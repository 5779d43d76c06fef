/* A robot as kernels see it: the row of its state, in the order of `state/robot_rows.py`, and that
   of its constants, in the order of `Drives.table`. */
#ifndef CRS_KERNELS_ROBOT_H
#define CRS_KERNELS_ROBOT_H

#define AXES 3

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
    long long listening;                                    /* -1 for none */
    unsigned char limp[AXES], hindered;
};

struct drive {
    double turn[AXES], forward[AXES], true_turn[AXES], true_forward[AXES], count[AXES], turret;
    double unit[AXES];
};

#endif
