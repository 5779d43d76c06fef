/* An object of a struct that is never completed. */
struct unknown;

int main(void)
{
    struct unknown u; // error: incomplete
    return 0;
}
