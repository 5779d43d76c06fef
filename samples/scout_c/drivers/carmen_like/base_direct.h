/*
 * base_direct.h - the interface of a robot base: metres, radians, seconds.
 *
 * The server in base.c knows nothing else about the robot. Functions return 0, or -1 on
 * failure; results are stored through the pointers, which may be NULL.
 */

#ifndef BASE_DIRECT_H
#define BASE_DIRECT_H

int base_direct_initialize_robot(char *model, char *dev);
int base_direct_shutdown_robot(void);
int base_direct_reset(void);
int base_direct_sonar_on(void);
int base_direct_sonar_off(void);
int base_direct_set_acceleration(double acceleration);
int base_direct_set_deceleration(double deceleration);
int base_direct_set_velocity(double tv, double rv);
int base_direct_update_status(void);
int base_direct_get_state(double *displacement, double *rotation, double *tv, double *rv);
int base_direct_get_integrated_state(double *x, double *y, double *theta, double *tv, double *rv);
int base_direct_get_sonars(double *ranges, int num_sonars);
int base_direct_get_bumpers(unsigned char *state, int num_bumpers);
int base_direct_get_binary_data(unsigned char **data, int *size);

double get_time(void);

#endif
