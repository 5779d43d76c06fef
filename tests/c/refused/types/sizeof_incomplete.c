/* sizeof of a struct that is only declared. */
struct unknown;

int main(void)
{
    return sizeof(struct unknown); // error: incomplete
}
