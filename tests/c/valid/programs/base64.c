/* Base64, hexadecimal dump, ROT13, Caesar and Vigenere. */
#include <stdio.h>
#include <string.h>
#include <ctype.h>

static const char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

static char *encode(const unsigned char *in, int n, char *out)
{
    char *start = out;

    for (; n > 0; in += 3, n -= 3) {
        unsigned word = in[0] << 16 | (n > 1 ? in[1] : 0) << 8 | (n > 2 ? in[2] : 0);
        *out++ = alphabet[word >> 18];
        *out++ = alphabet[word >> 12 & 63];
        *out++ = n > 1 ? alphabet[word >> 6 & 63] : '=';
        *out++ = n > 2 ? alphabet[word & 63] : '=';
    }
    *out = 0;
    return start;
}

static int decode(const char *in, char *out)
{
    unsigned word = 0;
    int bits = 0, n = 0;

    for (; *in && *in != '='; in++) {
        word = word << 6 | (unsigned) (strchr(alphabet, *in) - alphabet);
        if ((bits += 6) >= 8)
            out[n++] = word >> (bits -= 8);
    }
    out[n] = 0;
    return n;
}

static void dump(const void *data, int n)
{
    const unsigned char *p = data;
    int i;

    for (i = 0; i < n; i++)
        printf("%02x%s", p[i], i % 8 == 7 || i == n - 1 ? "  " : " ");
    for (i = 0; i < n; i++)
        putchar(isprint(p[i]) ? p[i] : '.');
    putchar('\n');
}

static void vigenere(char *text, const char *key, int sign)
{
    int i = 0;

    for (; *text; text++)
        if (isupper((unsigned char) *text)) {
            int shift = key[i++ % strlen(key)] - 'A';
            *text = 'A' + (*text - 'A' + sign * shift + 26) % 26;
        }
}

int main(void)
{
    const char *texts[] = { "M", "Ma", "Man", "sonar ring", "\xff\xfe\xfd\xfc" };
    char coded[40], back[40], secret[] = "ATTACK AT DAWN";
    int i;

    for (i = 0; i < 5; i++) {
        encode((const unsigned char *) texts[i], strlen(texts[i]), coded);
        printf("%s %d ", coded, decode(coded, back));
        dump(back, strlen(back));
    }
    vigenere(secret, "LEMON", 1);
    printf("%s\n", secret);
    vigenere(secret, "LEMON", -1);
    printf("%s\n", secret);
    return 0;
}
