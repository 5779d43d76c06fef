/* Requests, the only interface of a control program to its environment: the message that is posted
   is replaced by the reply. The codes are those of crs_cc/requests, which has their units and
   meanings; a test compares the two. Both functions are compiler intrinsics. */
#ifndef _CRS_REQUEST_H
#define _CRS_REQUEST_H

struct __crs_message {
    int i[8];                /* integer arguments, then integer results */
    double f[4];             /* floating arguments, then floating results */
    int size;                /* bytes of `data` in use, 0 to 248 */
    int result;              /* the reply's result */
    unsigned char data[248];
};

#define CRS_DATA_SIZE 248

#define CRS_EXIT 1
#define CRS_WRITE 2
#define CRS_READ 3
#define CRS_CLOCK 4
#define CRS_SLEEP 5
#define CRS_ARGUMENT 6
#define CRS_FILE_OPEN 7
#define CRS_FILE_CLOSE 8
#define CRS_FILE_READ 9
#define CRS_FILE_WRITE 10
#define CRS_FILE_RESIZE 11
#define CRS_FILE_REMOVE 12
#define CRS_FILE_RENAME 13
#define CRS_CLIENT 14
#define CRS_UNCONNECTED 15
#define CRS_INPUT 16
#define CRS_FILE_LIST 17
#define CRS_SOCKET_OPEN 20
#define CRS_SOCKET_PAIR 21
#define CRS_SOCKET_CLOSE 22
#define CRS_SOCKET_BIND 23
#define CRS_SOCKET_LISTEN 24
#define CRS_SOCKET_CONNECT 25
#define CRS_SOCKET_ACCEPT 26
#define CRS_SOCKET_SEND 27
#define CRS_SOCKET_RECEIVE 28
#define CRS_SOCKET_SHUTDOWN 29
#define CRS_SOCKET_NAME 30
#define CRS_SOCKET_ERROR 31
#define CRS_SOCKET_POLL 32
#define CRS_SOCKET_WAIT 33
#define CRS_NETWORK_ADDRESS 34
#define CRS_NETWORK_NAME 35
#define CRS_CONNECT 100
#define CRS_DISCONNECT 101
#define CRS_AC 102
#define CRS_SP 103
#define CRS_PR 104
#define CRS_VM 105
#define CRS_MV 106
#define CRS_ST 107
#define CRS_LP 108
#define CRS_WS 109
#define CRS_DP 110
#define CRS_DA 111
#define CRS_ZR 112
#define CRS_CONF_SN 113
#define CRS_CONF_TM 114
#define CRS_GS 115
#define CRS_GET_SN 116
#define CRS_GET_BP 117
#define CRS_GET_RC 118
#define CRS_GET_RV 119
#define CRS_CT 121
#define CRS_GET_IR 122
#define CRS_GET_RA 123
#define CRS_GET_CP 124
#define CRS_GET_LS 125
#define CRS_GET_SG 126
#define CRS_CONF_IR 127
#define CRS_CONF_CP 128
#define CRS_CONF_LS 129
#define CRS_CONF_SG 130
#define CRS_LASER_PAGE 131
#define CRS_POS_DATA 132
#define CRS_TK 133
#define CRS_CONF_SER 134
#define CRS_PLACE_ROBOT 140
#define CRS_ADD_OBSTACLE 141
#define CRS_DELETE_OBSTACLE 142
#define CRS_MOVE_OBSTACLE 143
#define CRS_NEW_WORLD 144
#define CRS_GET_RPX 145
#define CRS_PREDICT 146
#define CRS_MOTION_CHECK 147
#define CRS_GET_CONF 148
#define CRS_REAL_ROBOT 149
#define CRS_SIMULATED_ROBOT 150
#define CRS_DRAW 151
#define CRS_REFRESH 152
#define CRS_QUIT_SERVER 153
#define CRS_CREATE 154
#define CRS_SPECIAL 155
#define CRS_SONAR 160
#define CRS_HEAT 161
#define CRS_TAG 162
#define CRS_READINGS 202
#define CRS_PERIOD 205
#define CRS_AGE 206
#define CRS_SEND 240
#define CRS_RECEIVE 241
#define CRS_MESSAGE_COUNT 242
#define CRS_GROUP 243
#define CRS_CHANNEL 244
#define CRS_ROBOT 245
#define CRS_FIELD 246

/* Post the message; return the result of the reply. */
int __crs_request(int code, struct __crs_message *message);

/* Stop the program with an error of requests.ERROR_KINDS, given as a string literal, optionally
   followed by the faulting address. */
void __crs_stop(const char *kind, ...);

#endif
