/* A static assertion that fails. */
_Static_assert(sizeof(long) == 8, "this program needs 64 bits"); // error: this program needs 64 bits

int main(void)
{
    return 0;
}
