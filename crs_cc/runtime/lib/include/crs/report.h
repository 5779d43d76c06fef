/* The report's dialect: what is declared in a control program in the form of the CRS report,
   without including anything ("copied without the C headers", report, 6.1).

   The names are the report's, and mean its functions and not the vendor's, which the linker knows
   by other names. Lengths are in 0.1 inch, angles in 0.1 degree. Where the report contradicts
   itself or is silent, docs/robot-api.md describes the choice.

   With --dialect report, including the vendor's header includes this one. */
#ifndef _CRS_REPORT_H
#define _CRS_REPORT_H
#define _HOST_CLIENT_NCLIENT_H_
#define _HOST_CLIENT_H_

#include <stdio.h>

/* Words of Java that such programs were written with. */
typedef char *String;
typedef _Bool boolean;
#ifndef true
#define true 1
#define false 0
#endif

#define FALSE 0
#define TRUE 1

#define MODEL_N200 0
#define MODEL_N150 1
#define MODEL_SCOUT 2
#define MODEL_SCOUT2 2

/* Modes of a wheel, for mv. */
#define MV_IGNORE 0
#define MV_VM 1
#define MV_PR 2
#define MV_LP 3
#define MV_AC 4
#define MV_SP 5

/* Indices into State: those of the vendor's State, followed by the heat. */
#define NUM_STATE 46
#define STATE_SONAR_0 17          /* front; the others counterclockwise, 22.5 degrees apart */
#define STATE_SONAR_1 18
#define STATE_SONAR_2 19
#define STATE_SONAR_3 20
#define STATE_SONAR_4 21
#define STATE_SONAR_5 22
#define STATE_SONAR_6 23
#define STATE_SONAR_7 24
#define STATE_SONAR_8 25
#define STATE_SONAR_9 26
#define STATE_SONAR_10 27
#define STATE_SONAR_11 28
#define STATE_SONAR_12 29
#define STATE_SONAR_13 30
#define STATE_SONAR_14 31
#define STATE_SONAR_15 32         /* distances in 0.1 inch, -1 where nothing is in range */
#define STATE_BUMPER 33           /* 1 while the robot touches something, else 0 */
#define STATE_CONF_X 34
#define STATE_CONF_Y 35
#define STATE_CONF_STEER 36       /* heading, 0 to 3599, counterclockwise */
#define STATE_CONF_TURRET 37
#define STATE_VEL_TRANS 38
#define STATE_VEL_RIGHT 38
#define STATE_VEL_STEER 39
#define STATE_VEL_LEFT 39
#define STATE_VEL_TURRET 40
#define STATE_MOTOR_STATUS 41     /* bit 0: right motor active, bit 1: left motor */
#define STATE_ERROR 44
#define STATE_HEAT 45             /* the heat of all objects in the sensor's range */

extern long State[NUM_STATE] __asm__("__report_State");

/* Communication. connect_robot(id, port, machine), or (id, model, device, v). */
int connect_robot(int id, ...) __asm__("__report_connect_robot");
int disconnect_robot(int id) __asm__("__report_disconnect_robot");
int conf_tm(int timeout) __asm__("__report_conf_tm");
int real_robot(void) __asm__("__report_real_robot");
int simulated_robot(void) __asm__("__report_simulated_robot");

/* Motion. */
int pr(int r_wheel, int l_wheel, int dummy) __asm__("__report_pr");
int vm(double speed) __asm__("__report_vm");
int mv(int r_mode, int r_value, int l_mode, int l_value, int dummy_mode, int dummy_value)
    __asm__("__report_mv");
int st(void) __asm__("__report_st");
int ws(int x, int y, int z, int dummy) __asm__("__report_ws");
/* A way, and a turn to the right. */
int scout_pr(int trans, int steer) __asm__("__report_scout_pr");
int scout_vm(int trans, int steer) __asm__("__report_scout_vm");

/* Initial speeds and accelerations. */
int dp(int x, int y) __asm__("__report_dp");
int ac(int r_wheel, int l_wheel, int dummy) __asm__("__report_ac");
int sp(int r_wheel, int l_wheel, int dummy) __asm__("__report_sp");

/* Sensors. */
int conf_sn(int rate, int order[]) __asm__("__report_conf_sn");
int get_sn(void) __asm__("__report_get_sn");
int get_bp(void) __asm__("__report_get_bp");
int sonarSensorCheck(void) __asm__("__report_sonarSensorCheck");
int heatSensorCheck(void) __asm__("__report_heatSensorCheck");
int tagTarget(void) __asm__("__report_tagTarget");

/* Chapter 2 has vm with the wheels' speeds, chapter 3 with that of the robot: both are meant. */
int vm_of_wheels(int r_wheel, int l_wheel, int dummy) __asm__("__report_vm_of_wheels");
#define __report_sixth(a, b, c, d, e, name, ...) name
#define vm(...)                                                                                \
    __report_sixth(__VA_ARGS__, vm_of_wheels, vm_of_wheels, vm_of_wheels, vm_of_wheels, vm)    \
    (__VA_ARGS__)

#endif
