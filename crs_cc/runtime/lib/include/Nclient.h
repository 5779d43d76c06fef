/* The Nomadic client library, the interface of control programs to their robot.

   An independent implementation of the vendor's header 1.29 of 1999: same names, values and
   meanings. On the Scout axis 1 ("translation") is the right wheel and axis 2 ("steering") the left
   wheel. Lengths are in 0.1 inch, angles in 0.1 degree, counterclockwise, sonar readings in inches;
   speeds and accelerations in these units per second and per second squared.
   Functions return TRUE, or FALSE if they fail or no robot is connected. Reference:
   docs/robot-api.md. */
#ifndef _HOST_CLIENT_NCLIENT_H_
#define _HOST_CLIENT_NCLIENT_H_

#ifndef FALSE
#define FALSE 0
#endif
#ifndef TRUE
#define TRUE 1
#endif
#ifndef NULL
#define NULL ((void *)0)
#endif

#define MAX_VERTICES 10
#define NUM_STATE 45
#define NUM_MASK 44
#define NUM_LASER 482
#define BUFSIZE 4096
#define MAX_USER_BUF 0xFFFF
#define USER_BUFFER_LENGTH 0xFFFF
#define SONARS 16
#define INFRAREDS 16

/* Robot models. */
#define MODEL_N200 0
#define MODEL_N150 1
#define MODEL_SCOUT 2
#define MODEL_SCOUT2 2

/* Modes of an axis, for mv. */
#define MV_IGNORE 0
#define MV_VM 1
#define MV_PR 2
#define MV_LP 3
#define MV_AC 4
#define MV_SP 5
#define MV_PA 6
#define MV_TQ 7
#define MV_MT 8

/* Modes of arm_zr: how the arm finds its zero position. */
#define ZR_CHECK 1
#define ZR_ORIENT 2
#define ZR_NO_N_GRIPPER 4

/* Packet types of the arm. */
#define ARM_ZR 40
#define ARM_WS 41
#define ARM_MV 42

/* Sensors whose replies can contain the position and time of the reading; bits. */
#define POS_NONE 0
#define POS_INFRARED 1
#define POS_SONAR 2
#define POS_BUMPER 4
#define POS_LASER 8
#define POS_COMPASS 16

/* 1 if position data is requested for the sensor, else 0. */
#define POS_INFRARED_P (posDataCheck() & POS_INFRARED ? 1 : 0)
#define POS_SONAR_P (posDataCheck() & POS_SONAR ? 1 : 0)
#define POS_BUMPER_P (posDataCheck() & POS_BUMPER ? 1 : 0)
#define POS_LASER_P (posDataCheck() & POS_LASER ? 1 : 0)
#define POS_COMPASS_P (posDataCheck() & POS_COMPASS ? 1 : 0)

/* Sensor numbers in position data. */
#define POS_IR_1 0
#define POS_IR_2 1
#define POS_IR_3 2
#define POS_IR_4 3
#define POS_IR_5 4
#define POS_IR_6 5
#define POS_IR_7 6
#define POS_IR_8 7
#define POS_IR_9 8
#define POS_IR_10 9
#define POS_IR_11 10
#define POS_IR_12 11
#define POS_IR_13 12
#define POS_IR_14 13
#define POS_IR_15 14
#define POS_IR_16 15
#define POS_SONAR_1 0
#define POS_SONAR_2 1
#define POS_SONAR_3 2
#define POS_SONAR_4 3
#define POS_SONAR_5 4
#define POS_SONAR_6 5
#define POS_SONAR_7 6
#define POS_SONAR_8 7
#define POS_SONAR_9 8
#define POS_SONAR_10 9
#define POS_SONAR_11 10
#define POS_SONAR_12 11
#define POS_SONAR_13 12
#define POS_SONAR_14 13
#define POS_SONAR_15 14
#define POS_SONAR_16 15

/* Indices into State. */
#define STATE_SIM_SPEED 0       /* speed of the simulation, 10 is real time */
#define STATE_IR_0 1
#define STATE_IR_1 2
#define STATE_IR_2 3
#define STATE_IR_3 4
#define STATE_IR_4 5
#define STATE_IR_5 6
#define STATE_IR_6 7
#define STATE_IR_7 8
#define STATE_IR_8 9
#define STATE_IR_9 10
#define STATE_IR_10 11
#define STATE_IR_11 12
#define STATE_IR_12 13
#define STATE_IR_13 14
#define STATE_IR_14 15
#define STATE_IR_15 16
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
#define STATE_SONAR_15 32
#define STATE_BUMPER 33
#define STATE_CONF_X 34
#define STATE_CONF_Y 35
#define STATE_CONF_STEER 36     /* heading, 0 to 3599 */
#define STATE_CONF_TURRET 37
#define STATE_VEL_TRANS 38
#define STATE_VEL_RIGHT 38
#define STATE_VEL_STEER 39
#define STATE_VEL_LEFT 39
#define STATE_VEL_TURRET 40
#define STATE_MOTOR_STATUS 41   /* bit 0: right motor active, bit 1: left motor, bit 2: turret */
#define STATE_LASER 42
#define STATE_COMPASS 43
#define STATE_ERROR 44

/* Indices into Smask. */
#define SMASK_POS_DATA 0
#define SMASK_IR_1 1
#define SMASK_IR_2 2
#define SMASK_IR_3 3
#define SMASK_IR_4 4
#define SMASK_IR_5 5
#define SMASK_IR_6 6
#define SMASK_IR_7 7
#define SMASK_IR_8 8
#define SMASK_IR_9 9
#define SMASK_IR_10 10
#define SMASK_IR_11 11
#define SMASK_IR_12 12
#define SMASK_IR_13 13
#define SMASK_IR_14 14
#define SMASK_IR_15 15
#define SMASK_IR_16 16
#define SMASK_SONAR_1 17
#define SMASK_SONAR_2 18
#define SMASK_SONAR_3 19
#define SMASK_SONAR_4 20
#define SMASK_SONAR_5 21
#define SMASK_SONAR_6 22
#define SMASK_SONAR_7 23
#define SMASK_SONAR_8 24
#define SMASK_SONAR_9 25
#define SMASK_SONAR_10 26
#define SMASK_SONAR_11 27
#define SMASK_SONAR_12 28
#define SMASK_SONAR_13 29
#define SMASK_SONAR_14 30
#define SMASK_SONAR_15 31
#define SMASK_SONAR_16 32
#define SMASK_BUMPER 33
#define SMASK_CONF_X 34
#define SMASK_CONF_Y 35
#define SMASK_CONF_STEER 36
#define SMASK_CONF_TURRET 37
#define SMASK_VEL_TRANS 38
#define SMASK_VEL_STEER 39
#define SMASK_VEL_TURRET 40
#define SMASK_RESERVED 41
#define SMASK_LASER 42
#define SMASK_COMPASS 43

/* The state according to the last reply, and the mask of the elements that replies update, which
   ct sends. */
extern long State[NUM_STATE];
extern int Smask[NUM_MASK];

/* The number of laser readings, and the readings: points of two numbers, or segments of four. */
extern int Laser[2 * NUM_LASER + 1];

/* Host and port of the server; set before connect_robot. */
extern char SERVER_MACHINE_NAME[80];
extern int SERV_TCP_PORT;

/* For compatibility; they have no effect. */
extern char ROBOT_MACHINE_NAME[80];
extern int CONN_TYPE;
extern char SERIAL_PORT[40];
extern int SERIAL_BAUD;
extern int ROBOT_TCP_PORT;
extern double LASER_CALIBRATION[8];
extern double LASER_OFFSET[2];

/* A rotation of the Scout in degrees, as wheel travel: inches per degree. */
#ifndef ROTATION_CONSTANT
#define ROTATION_CONSTANT 0.118597
#endif

/* Wheel values of a translation and a rotation; the arguments are used as they are written. */
#ifndef RIGHT
#define RIGHT(trans, steer) (trans + (int)((float)steer*ROTATION_CONSTANT))
#endif
#ifndef LEFT
#define LEFT(trans, steer) (trans - (int)((float)steer*ROTATION_CONSTANT))
#endif
#ifndef scout_vm
#define scout_vm(trans, steer) vm(RIGHT(trans, steer), LEFT(trans, steer), 0)
#endif

/* Connection. */
int create_robot(long robot_id);
int connect_robot(long robot_id, ...);
int disconnect_robot(long robot_id);
int server_is_running(void);
int quit_server(void);
int real_robot(void);
int simulated_robot(void);
int set_server_machine_name(char *name);
int set_serv_tcp_port(int port);

/* Motion. */
int ac(int trans, int steer, int turret);
int sp(int trans, int steer, int turret);
int pr(int trans, int steer, int turret);
int vm(int trans, int steer, int turret);
int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv);
int st(void);
int lp(void);
int ws(unsigned char trans, unsigned char steer, unsigned char turret, unsigned char timeout);
int dp(int x, int y);
int da(int th, int tu);
int zr(void);

/* Configuration. */
int conf_sn(int rate, int order[16]);
int conf_ir(int history, int order[16]);
int conf_cp(int mode);
int conf_ls(unsigned int mode, unsigned int threshold, unsigned int width, unsigned int num_data,
            unsigned int processing);
int conf_sg(unsigned int threshold, unsigned int min_points, unsigned int gap);
int conf_tm(unsigned char timeout);
int ct(void);
void init_mask(void);
int init_sensors(void);
int get_mask(int mask[NUM_MASK]);
int set_mask(int mask[NUM_MASK]);

/* Reading State, or a group of it. */
int gs(void);
int get_ir(void);
int get_sn(void);
int get_rc(void);
int get_rv(void);
int get_ra(void);
int get_cp(void);
int get_ls(void);
int get_bp(void);
int get_sg(void);
int get_state(long state[NUM_STATE]);
int get_laser(int laser[2 * NUM_LASER + 1]);

/* The simulator's world. */
int add_obstacle(long obs[2 * MAX_VERTICES + 1]);
int add_Obs(long obs[2 * MAX_VERTICES + 1]);
int delete_obstacle(long obs[2 * MAX_VERTICES + 1]);
int delete_Obs(long obs[2 * MAX_VERTICES + 1]);
int move_obstacle(long obs[2 * MAX_VERTICES + 1], long dx, long dy);
int move_Obs(long obs[2 * MAX_VERTICES + 1], long dx, long dy);
int new_world(void);
int place_robot(int x, int y, int th, int tu);
int get_rpx(long *robot_pos);
int predict_sensors(int x, int y, int th, int tu, long *state, int *laser);
int motion_check(long type, double a1, double a2, double a3, double a4, double a5, double a6,
                 double a7, double collide[3]);
int get_robot_conf(long *conf);

/* The simulator's window. */
int draw_robot(long x, long y, int th, int tu, int mode);
int draw_line(long x_1, long y_1, long x_2, long y_2, int mode);
int draw_arc(long x_0, long y_0, long w, long h, int th1, int th2, int mode);
int refresh_all(void);
int refresh_all_traces(void);
int refresh_actual_trace(void);
int refresh_encoder_trace(void);
int refresh_all_sensors(void);
int refresh_bumper_sensor(void);
int refresh_infrared_sensor(void);
int refresh_sonar_sensor(void);
int refresh_laser_sensor(void);
int refresh_client_graphics(void);

/* Position and time of sensor readings; times are in ms, of the clock of the sensor board. */
typedef unsigned long TimeData;

typedef struct _ConfigData {
    long configX, configY, configSteer, configTurret;
    long velTrans, velSteer, velTurret;
    TimeData timeStamp;
} ConfigData;

typedef struct _PosData {
    ConfigData config;
    TimeData timeStamp;
} PosData;

int posDataRequest(int posRequest);
int posDataCheck(void);
int posInfraredRingGet(PosData posData[INFRAREDS]);
int posInfraredGet(PosData *posData, int infraredNumber);
int posSonarRingGet(PosData posData[SONARS]);
int posSonarGet(PosData *posData, int sonarNumber);
int posBumperGet(PosData *posData);
int posLaserGet(PosData *posData);
int posCompassGet(PosData *posData);
int posTimeGet(void);

/* Battery voltages. */
float voltCpuGet(void);
float voltMotorGet(void);

/* Speech. */
int tk(char *talk);

/* User-defined packets. */
typedef union {
    char bytes[8];
    double data;
} double_union;

typedef union {
    char bytes[4];
    short words[2];
    long data;
} long_union;

typedef union {
    unsigned char bytes[2];
    short data;
} short_union;

typedef union {
    unsigned char bytes[2];
    unsigned short data;
} ushort_union;

typedef union {
    unsigned char bytes[4];
    unsigned short words[2];
    unsigned long data;
} ulong_union;

struct request_struct {
    short type;
    unsigned short size;
    long mesg[USER_BUFFER_LENGTH];
};

struct reply_struct {
    short type;
    unsigned short size;
    long mesg[USER_BUFFER_LENGTH];
};

int special_request(unsigned char *user_send_buffer, unsigned char *user_receive_buffer);
int init_receive_buffer(unsigned short *index);
int extract_receive_buffer_header(unsigned short *length, unsigned char *serial_number,
                                  unsigned char *packet_type, unsigned char *buffer);
int init_send_buffer(unsigned short *index);
int stuff_send_buffer_header(unsigned short index, unsigned char serial_number,
                             unsigned char packet_type, unsigned char *buffer);
int stuffchar(signed char data, unsigned char *buffer, unsigned short *index);
int stuff2byteint(signed short data, unsigned char *buffer, unsigned short *index);
int stuff4byteint(signed long data, unsigned char *buffer, unsigned short *index);
int stuffuchar(unsigned char data, unsigned char *buffer, unsigned short *index);
int stuff2byteuint(unsigned short data, unsigned char *buffer, unsigned short *index);
int stuff4byteuint(unsigned long data, unsigned char *buffer, unsigned short *index);
int stuffdouble(double data, unsigned char *buffer, unsigned short *index);
signed char extractchar(unsigned char *buffer, unsigned short *index);
signed short extract2byteint(unsigned char *buffer, unsigned short *index);
signed long extract4byteint(unsigned char *buffer, unsigned short *index);
unsigned char extractuchar(unsigned char *buffer, unsigned short *index);
unsigned short extract2byteuint(unsigned char *buffer, unsigned short *index);
unsigned long extract4byteuint(unsigned char *buffer, unsigned short *index);
double extractdouble(unsigned char *buffer, unsigned short *index);

/* The arm. */
long arm_mv(long l_mode, long l_v, long g_mode, long g_v);
long arm_ws(short lift, short grip, long timeout, long *time_remain);
long arm_zr(short mode);

/* Not in the vendor's header: functions that Scout programs commonly define for themselves. A
   program's own macros or functions of these names replace them. */
#ifndef scout_pr
int scout_pr(int trans, int steer);
#endif
#ifndef scout_ws
int scout_ws(int seconds);
#endif
int sonarSensorCheck(void);

#endif
