/* The only door out of a control program: fill in a message, post it, find the reply in its place.
   The same as crs_cc/requests.py, where units and meaning of every code are written; a test holds
   the two together. Both functions are intrinsics of the compiler. */
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

/* Posts the message and gives the reply's result. */
int __crs_request(int code, struct __crs_message *message);

/* Ends the program with an error of requests.ERROR_KINDS, named by a string literal; behind it may
   stand the address to blame. */
void __crs_stop(const char *kind, ...);

#endif
