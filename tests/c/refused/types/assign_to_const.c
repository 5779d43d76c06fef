/* Assignment to a const object. */
static const int limit = 5;

int main(void)
{
    limit = 6; // error: const
    return limit;
}
