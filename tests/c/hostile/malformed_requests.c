/* Every code that is served, with absurd sizes, huge integers, NaN and infinities. */
// ends: exit 0
#include <crs_request.h>
#include <string.h>

int main(void)
{
    static const int codes[] = {
        CRS_WRITE, CRS_READ, CRS_CLOCK, CRS_SLEEP, CRS_ARGUMENT, CRS_CONNECT, CRS_AC, CRS_SP, CRS_PR,
        CRS_VM, CRS_MV, CRS_ST, CRS_LP, CRS_DP, CRS_DA, CRS_ZR, CRS_CONF_SN, CRS_CONF_TM, CRS_GS,
        CRS_GET_SN, CRS_GET_BP, CRS_GET_RC, CRS_GET_RV, CRS_DISCONNECT, CRS_WS, CRS_FILE_OPEN,
        CRS_FILE_CLOSE, CRS_FILE_READ, CRS_FILE_WRITE, CRS_FILE_RESIZE, CRS_FILE_REMOVE,
        CRS_FILE_RENAME,
    };
    static const int words[] = { 0, 1, -1, 2147483647, -2147483647 - 1, 249, 65536, 16777216 };
    struct __crs_message message;
    double zero = 0, values[] = { zero / zero, 1 / zero, -1 / zero, 1e308, -5e-324 };
    unsigned code, word, i;

    for (word = 0; word < sizeof words / sizeof *words; word++)
        for (code = 0; code < sizeof codes / sizeof *codes; code++) {
            memset(&message, word * 85, sizeof message);
            for (i = 0; i < 8; i++)
                message.i[i] = words[(word + i * (code & 1)) % 8];
            for (i = 0; i < 4; i++)
                message.f[i] = values[(word + i) % 5];
            message.size = words[word];
            if (codes[code] == CRS_WS)
                message.i[3] = 0;
            __crs_request(codes[code], &message);
        }
    return 0;
}
