/* The Nomadic client: how a control program talks to its robot.

   Written anew with the names, values and meanings of the vendor's header 1.29 of 1999. On the
   Scout axis 1 ("translation") is the right wheel and axis 2 ("steering") the left wheel.
   Lengths are in 0.1 inch, angles in 0.1 degree, counted counterclockwise, sonar readings in
   inches; speeds and accelerations the same per second and per second squared.
   Functions give TRUE, or FALSE when they failed or no robot is connected. */
#ifndef _HOST_CLIENT_H_
#define _HOST_CLIENT_H_

#ifndef FALSE
#define FALSE 0
#endif
#ifndef TRUE
#define TRUE 1
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

/* Where things stand in State. */
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
#define STATE_MOTOR_STATUS 41   /* bit 0: right motor active, bit 1: left motor */
#define STATE_LASER 42
#define STATE_COMPASS 43
#define STATE_ERROR 44

/* Where things stand in Smask. */
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

extern long State[NUM_STATE];
extern int Smask[NUM_MASK];
extern char SERVER_MACHINE_NAME[80];
extern int SERV_TCP_PORT;

/* A rotation of the Scout in degrees, as wheel travel: inches per degree. */
#define ROTATION_CONSTANT 0.118597

/* Wheel values of a translation and a rotation; the arguments are used as they are written. */
#define RIGHT(trans, steer) (trans + (int)((float)steer*ROTATION_CONSTANT))
#define LEFT(trans, steer) (trans - (int)((float)steer*ROTATION_CONSTANT))
#define scout_vm(trans, steer) vm(RIGHT(trans, steer), LEFT(trans, steer), 0)

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

/* Configuration. */
int conf_ir(int history, int order[16]);
int conf_sn(int rate, int order[16]);
int conf_cp(int mode);
int conf_ls(unsigned int mode, unsigned int threshold, unsigned int width, unsigned int num_data, unsigned int processing);
int conf_sg(unsigned int threshold, unsigned int min_points, unsigned int gap);
int conf_tm(unsigned char timeout);
int conf_ser(unsigned char port, unsigned short baud);
int ct(void);
int init_sensors(void);
void init_mask(void);

/* Motion. */
int ac(int trans, int steer, int turret);
int sp(int trans, int steer, int turret);
int pr(int trans, int steer, int turret);
int pa(int trans, int steer, int turret);
int vm(int trans, int steer, int turret);
int mv(int t_mode, int t_mv, int s_mode, int s_mv, int r_mode, int r_mv);
int st(void);
int lp(void);
int ws(unsigned char trans, unsigned char steer, unsigned char turret, unsigned char timeout);
int dp(int x, int y);
int da(int th, int tu);
int zr(void);
int place_robot(int x, int y, int th, int tu);

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
int get_rpx(long *robot_pos);

/* The simulator's world. */
int add_obstacle(long obs[2 * MAX_VERTICES + 1]);
int add_Obs(long obs[2 * MAX_VERTICES + 1]);
int delete_obstacle(long obs[2 * MAX_VERTICES + 1]);
int delete_Obs(long obs[2 * MAX_VERTICES + 1]);
int move_obstacle(long obs[2 * MAX_VERTICES + 1], long dx, long dy);
int move_Obs(long obs[2 * MAX_VERTICES + 1], long dx, long dy);
int new_world(void);
int predict_sensors(int x, int y, int th, int tu, long *state, int *laser);
int motion_check(long type, double a1, double a2, double a3, double a4, double a5, double a6, double a7, double collide[3]);
int get_robot_conf(long *conf);

/* The simulator's window. */
int draw_robot(long x, long y, int th, int tu, int mode);
int draw_line(long x_1, long y_1, long x_2, long y_2, int mode);
int draw_arc(long x_0, long y_0, long w, long h, int th1, int th2, int mode);
int refresh_all(void);

/* Others. */
int tk(char *talk);
int special_request(unsigned char *user_send_buffer, unsigned char *user_receive_buffer);

/* Where and when sensors were read. */
typedef unsigned long TimeData;

typedef struct {
    long configX, configY, configSteer, configTurret, velTrans, velSteer, velTurret;
    TimeData timeStamp;
} ConfigData;

typedef struct {
    ConfigData config;
    TimeData timeStamp;
} PosData;

int posSonarRingGet(PosData posData[SONARS]);

/* Not the vendor's: what Scout programs used to define for themselves. They are functions, so
   that a program's own macros or functions of these names take their place. */
int scout_pr(int trans, int steer);
int scout_ws(int seconds);
int sonarSensorCheck(void);

#endif
